#pragma once

#include <scree/tensor.hpp>

#include <algorithm>
#include <bit>
#include <cstdint>

namespace scree::transport::detail {

/// A running maximum of magnitudes that a NaN does not slip through: the bit patterns of doubles that are
/// not negative are ordered as the doubles are, infinity and NaN on top.
class Maximum {
 public:
  void add(const double* values, Index count) noexcept {
    std::int64_t largest = bits_;
    for (Index i = 0; i < count; ++i) {
      largest = std::max(largest, std::bit_cast<std::int64_t>(values[i]) & magnitude);
    }
    bits_ = largest;
  }
  void add(const Maximum& other) noexcept { bits_ = std::max(bits_, other.bits_); }
  [[nodiscard]] double value() const noexcept { return std::bit_cast<double>(bits_); }

 private:
  static constexpr std::int64_t magnitude = 0x7fff'ffff'ffff'ffff;
  std::int64_t bits_ = 0;
};

}  // namespace scree::transport::detail
