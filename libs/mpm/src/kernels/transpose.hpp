#pragma once

#include "pack.hpp"

#include <cstring>

namespace scree::mpm::SCREE_INSTRUCTION_SET {

namespace detail {

using Register = Pack::Register;

#if defined(__AVX512F__)
/// Four fields of the points i and 4 + i.
inline Register load_row(const double* fours, std::ptrdiff_t stride, int i) noexcept {
  using Half [[gnu::vector_size(4 * sizeof(double))]] = double;
  Half low;
  Half high;
  std::memcpy(&low, fours + i * stride, sizeof low);
  std::memcpy(&high, fours + (4 + i) * stride, sizeof high);
  return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}
inline void store_row(const Register& row, double* fours, std::ptrdiff_t stride, int i) noexcept {
  const auto low = __builtin_shufflevector(row, row, 0, 1, 2, 3);
  const auto high = __builtin_shufflevector(row, row, 4, 5, 6, 7);
  std::memcpy(fours + i * stride, &low, sizeof low);
  std::memcpy(fours + (4 + i) * stride, &high, sizeof high);
}
inline Register even(const Register& a, const Register& b) noexcept {
  return __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
}
inline Register odd(const Register& a, const Register& b) noexcept {
  return __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
}
inline Register low_pairs(const Register& a, const Register& b) noexcept {
  return __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13);
}
inline Register high_pairs(const Register& a, const Register& b) noexcept {
  return __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
}
#elif defined(__AVX__)
inline Register load_row(const double* fours, std::ptrdiff_t stride, int i) noexcept {
  return Pack::load(fours + i * stride).lanes();
}
inline void store_row(const Register& row, double* fours, std::ptrdiff_t stride, int i) noexcept {
  Pack{row}.store(fours + i * stride);
}
inline Register even(const Register& a, const Register& b) noexcept {
  return __builtin_shufflevector(a, b, 0, 4, 2, 6);
}
inline Register odd(const Register& a, const Register& b) noexcept {
  return __builtin_shufflevector(a, b, 1, 5, 3, 7);
}
inline Register low_pairs(const Register& a, const Register& b) noexcept {
  return __builtin_shufflevector(a, b, 0, 1, 4, 5);
}
inline Register high_pairs(const Register& a, const Register& b) noexcept {
  return __builtin_shufflevector(a, b, 2, 3, 6, 7);
}
#endif

}  // namespace detail

/// Field `f` of point `p`, lane `p` of `fields[f]`, goes to `fours[p * stride + f]`.
inline void to_fours(const Pack (&fields)[4], double* fours, std::ptrdiff_t stride) noexcept {
#if defined(__AVX__)
  using namespace detail;
  const Register a = even(fields[0].lanes(), fields[1].lanes());
  const Register b = odd(fields[0].lanes(), fields[1].lanes());
  const Register c = even(fields[2].lanes(), fields[3].lanes());
  const Register d = odd(fields[2].lanes(), fields[3].lanes());
  store_row(low_pairs(a, c), fours, stride, 0);
  store_row(low_pairs(b, d), fours, stride, 1);
  store_row(high_pairs(a, c), fours, stride, 2);
  store_row(high_pairs(b, d), fours, stride, 3);
#else
  for (int p = 0; p < Pack::size; ++p) {
    for (int f = 0; f < 4; ++f) fours[p * stride + f] = fields[f][p];
  }
#endif
}

/// The way back.
inline void from_fours(const double* fours, std::ptrdiff_t stride, Pack (&fields)[4]) noexcept {
#if defined(__AVX__)
  using namespace detail;
  const Register p0 = load_row(fours, stride, 0);
  const Register p1 = load_row(fours, stride, 1);
  const Register p2 = load_row(fours, stride, 2);
  const Register p3 = load_row(fours, stride, 3);
  const Register a = even(p0, p1);
  const Register b = odd(p0, p1);
  const Register c = even(p2, p3);
  const Register d = odd(p2, p3);
  fields[0] = Pack{low_pairs(a, c)};
  fields[1] = Pack{low_pairs(b, d)};
  fields[2] = Pack{high_pairs(a, c)};
  fields[3] = Pack{high_pairs(b, d)};
#else
  for (int f = 0; f < 4; ++f) {
    double lanes[Pack::size];
    for (int p = 0; p < Pack::size; ++p) lanes[p] = fours[p * stride + f];
    fields[f] = Pack::load(lanes);
  }
#endif
}

}  // namespace scree::mpm::SCREE_INSTRUCTION_SET
