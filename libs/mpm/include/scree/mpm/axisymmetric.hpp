#pragma once

#include <scree/mpm/hoop_columns.hpp>
#include <scree/mpm/point_term.hpp>
#include <scree/mpm/shapes.hpp>
#include <scree/mpm/stress_update.hpp>

#include <memory>
#include <optional>

namespace scree::mpm {

/// Makes points those of a flow round an axis of symmetry without swirl: axis 0 of the mesh is the radius,
/// from the axis of symmetry at its low end, which wants a wall that slips. Masses become those of a radian
/// [kg/rad] (each is multiplied by its radius), and columns for the hoop rate and the hoop stress are added,
/// so this comes before the stress update is made.  @see Eqs. (M150)-(M153)
/// @returns the terms of the hoop stress and of the divergence by v_r/r, for Stages::point_term
/// @throws InputError if axis 0 is periodic, or a point does not lie beside the axis of symmetry.
[[nodiscard]] std::unique_ptr<PointTerm<2, 2>> make_axisymmetric(Particles<2, 2>& particles,
                                                                 const CartesianGrid<2>& grid,
                                                                 const AnyShape& shape);

/// The velocity gradient of a point as laws see it, with its rate round the axis of symmetry if there is one.
/// @param hoop hoop_columns_of(particles)
template <int D, int V>
[[nodiscard]] Tensor<double> velocity_gradient_of(const Particles<D, V>& particles, Index p,
                                                  const std::optional<HoopColumns>& hoop) noexcept {
  Tensor<double> gradient = velocity_gradient_of(particles, p);
  if (hoop) gradient(2, 2) = particles.column(hoop->rate).component(0)[p];
  return gradient;
}

}  // namespace scree::mpm
