#pragma once

#include <scree/aligned.hpp>
#include <scree/quantity.hpp>
#include <scree/tensor.hpp>

#include <cstddef>
#include <span>

namespace scree::mpm {

/// One quantity of all points: `num_components` arrays of one length, one after the other, so that a loop
/// over points reads each of them contiguously.
class Column {
 public:
  /// @param quantity what is stored, for people and files
  /// @param num_components at least 1
  Column(Quantity quantity, int num_components);

  [[nodiscard]] const Quantity& quantity() const noexcept { return quantity_; }
  [[nodiscard]] int num_components() const noexcept { return num_components_; }
  [[nodiscard]] Index size() const noexcept { return size_; }

  /// The values of one component, a point each.
  [[nodiscard]] double* component(int c) noexcept { return values_.data() + c * size_; }
  [[nodiscard]] const double* component(int c) const noexcept { return values_.data() + c * size_; }

  /// All components, one after the other: num_components x size, point fastest.
  [[nodiscard]] std::span<double> values() noexcept { return values_; }
  [[nodiscard]] std::span<const double> values() const noexcept { return values_; }

  /// Memory that is held, in use or not [bytes].
  [[nodiscard]] std::size_t held_bytes() const noexcept { return values_.capacity() * sizeof(double); }

  /// Gives the column `size` points, all zero.
  void resize(Index size);

  /// New value of point p = old value of point source[p]; the column takes the length of `source`.
  void reorder(std::span<const Index> source);

  /// Adds the values of another column after its own.  @throws InputError if that has other components.
  void append(const Column& more);

 private:
  void make_room(std::size_t num_values);

  Quantity quantity_;
  int num_components_;
  Index size_ = 0;
  AlignedVector<double> values_;
};

}  // namespace scree::mpm
