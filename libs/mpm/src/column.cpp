#include <scree/error.hpp>
#include <scree/mpm/column.hpp>

#include <algorithm>
#include <memory>
#include <utility>

namespace scree::mpm {

Column::Column(Quantity quantity, int num_components)
    : quantity_{std::move(quantity)}, num_components_{num_components} {
  require(num_components >= 1, "Column '" + quantity_.name + "': must have at least one component");
}

void Column::resize(Index size) {
  size_ = size;
  values_.assign(static_cast<std::size_t>(num_components_ * size), 0.0);
}

void Column::reorder(std::span<const Index> source) {
  const auto size = static_cast<Index>(source.size());
  const std::size_t num_values = source.size() * static_cast<std::size_t>(num_components_);
  make_room(num_values);
  values_.resize(std::max(values_.size(), num_values));
  const auto sorted = std::make_unique_for_overwrite<double[]>(source.size());
  // A component that moves up would cover those above it, one that moves down those below: these go first.
  const bool grows = size > size_;
  for (int i = 0; i < num_components_; ++i) {
    const int c = grows ? num_components_ - 1 - i : i;
    const double* from = values_.data() + c * size_;
    std::ranges::transform(source, sorted.get(), [&](Index old) { return from[old]; });
    std::copy_n(sorted.get(), size, values_.begin() + c * size);
  }
  values_.resize(num_values);
  size_ = size;
}

void Column::append(const Column& more) {
  require(more.num_components_ == num_components_,
          "Column '" + quantity_.name + "': what is appended must have as many components");
  const Index size = size_ + more.size_;
  make_room(static_cast<std::size_t>(num_components_ * size));
  values_.resize(static_cast<std::size_t>(num_components_ * size));
  for (int c = num_components_ - 1; c >= 0; --c) {  // each moves up, but for the first
    const auto end = values_.begin() + c * size + size_;
    if (c * more.size_ > 0)
      std::copy_backward(values_.begin() + c * size_, values_.begin() + (c + 1) * size_, end);
    std::copy_n(more.component(c), more.size_, end);
  }
  size_ = size;
}

void Column::make_room(std::size_t num_values) {
  const std::size_t spare = num_values / 32;  // padding comes and goes
  if (num_values > values_.capacity()) values_.reserve(num_values + spare);
}

}  // namespace scree::mpm
