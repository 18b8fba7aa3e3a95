#pragma once

#include <scree/index.hpp>
#include <scree/mpm/point_transfer.hpp>

#include <cmath>

namespace scree::mpm::detail {

/// A point's place in the mesh, in units of the spacing: the first node of its stencil and the rest.
struct Place {
  Index base;
  double xi;
};

[[nodiscard]] inline Place place_of(double x, double origin, double inverse_spacing, double shift) noexcept {
  const double along = coordinate(x, origin, inverse_spacing, shift);
  const double base = std::floor(along);
  return {static_cast<Index>(base), along - base + shift};
}

}  // namespace scree::mpm::detail
