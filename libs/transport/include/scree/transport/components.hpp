#pragma once

#include <scree/tensor.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace scree::transport {

/// Calls body(0), .., body(N - 1), written out: no loop is left, so that a loop over sites round it can be
/// vectorised by the compiler whatever N.
template <int N, class Body>
constexpr void for_each_component(Body&& body) noexcept {
  [&]<std::size_t... Component>(std::index_sequence<Component...> /*components*/) {
    (body(Component), ...);
  }
  (std::make_index_sequence<static_cast<std::size_t>(N)>{});
}

/// The larger of two numbers, or NaN if either is NaN or infinite (std::max(a, NaN) would be a).
[[nodiscard]] constexpr double larger(double a, double b) noexcept {
  return (a > b ? a : b) + 0 * (a + b);
}

/// `a` if the condition holds, else `b`. With AVX a choice between numbers would become reads and sums under
/// masks, which are slow under AVX2, so bits are chosen; with less than AVX a loop is faster if it branches.
/// Always inlined: a program may have units with AVX and without.
[[nodiscard, gnu::always_inline]] constexpr double select(bool condition, double a, double b) noexcept {
#if defined(__AVX__)
  const std::uint64_t all_or_none = -static_cast<std::uint64_t>(condition);
  return std::bit_cast<double>((std::bit_cast<std::uint64_t>(a) & all_or_none) |
                               (std::bit_cast<std::uint64_t>(b) & ~all_or_none));
#else
  return condition ? a : b;
#endif
}
static_assert(select(true, 1, 2) == 1 && select(false, 1, 2) == 2);

/// a . b, component by component: inside a loop over faces Eigen's own packets would stand in the way of
/// the compiler's.
template <int D>
[[nodiscard]] double dot(const Vector<D>& a, const Vector<D>& b) noexcept {
  double sum = 0;
  for_each_component<D>([&](std::size_t k) { sum += a[static_cast<int>(k)] * b[static_cast<int>(k)]; });
  return sum;
}

/// The sum of a vector's components: of a unit normal, what a flux that is the same along every axis takes.
template <int D>
[[nodiscard]] double sum(const Vector<D>& a) noexcept {
  double result = 0;
  for_each_component<D>([&](std::size_t k) { result += a[static_cast<int>(k)]; });
  return result;
}

}  // namespace scree::transport
