#include <scree/error.hpp>
#include <scree/mpm/column.hpp>

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
  scratch_.resize(source.size() * static_cast<std::size_t>(num_components_));
  for (int c = 0; c < num_components_; ++c) {
    const double* from = component(c);
    double* to = scratch_.data() + c * size;
    for (const Index old : source) *to++ = from[old];
  }
  values_.swap(scratch_);
  size_ = size;
}

}  // namespace scree::mpm
