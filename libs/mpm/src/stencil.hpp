#pragma once

#include <scree/lattice.hpp>

#include <array>
#include <cmath>

namespace scree::mpm::detail {

/// support^D
template <int D>
constexpr std::size_t power(std::size_t base) {
  std::size_t product = 1;
  for (int i = 0; i < D; ++i) product *= base;
  return product;
}

/// The position of each node of a stencil along each axis, first axis fastest.
template <int D, std::size_t S>
constexpr std::array<std::array<std::size_t, D>, power<D>(S)> stencil_nodes() {
  std::array<std::array<std::size_t, D>, power<D>(S)> nodes{};
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    std::size_t rest = n;
    for (std::size_t axis = 0; axis < D; ++axis) {
      nodes[n][axis] = rest % S;
      rest /= S;
    }
  }
  return nodes;
}

/// A point's place in the mesh, in units of the spacing: the first node of its stencil and the rest.
struct Place {
  Index base;
  double xi;
};

/// A coordinate in units of the spacing, counted from where the stencil of node 0 begins. Every question of
/// where a point is must ask it here: another order of operations rounds to another node.
[[nodiscard]] inline double coordinate(double x, double origin, double inverse_spacing,
                                       double shift) noexcept {
  return (x - origin) * inverse_spacing - shift;
}

[[nodiscard]] inline Place place_of(double x, double origin, double inverse_spacing, double shift) noexcept {
  const double along = coordinate(x, origin, inverse_spacing, shift);
  const double base = std::floor(along);
  return {static_cast<Index>(base), along - base + shift};
}

}  // namespace scree::mpm::detail
