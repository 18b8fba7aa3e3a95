#pragma once

#include <scree/transport/cell_states.hpp>
#include <scree/transport/components.hpp>
#include <scree/transport/detail/face_tables.hpp>

#include <array>

namespace scree::transport::detail {

/// The derivative of a law's potential along a vector, by the least-squares gradient of a cell.  Eq. (T31)
template <class Law, int D, int N>
[[nodiscard]] std::array<double, static_cast<std::size_t>(N)> derivative_along(
    const Law& law, const FaceTables<D>& tables, const CellStates<N>& fields, Index cell,
    const Vector<D>& direction) noexcept {
  const auto here = law.potential(fields[cell]);
  std::array<double, static_cast<std::size_t>(N)> result{};
  for (const StencilCell<D>& near : tables.stencil_of(cell)) {
    const auto there = law.potential(fields[near.cell]);
    const double weight = dot<D>(near.weight, direction);
    for_each_component<N>([&](std::size_t k) { result[k] += weight * (there[k] - here[k]); });
  }
  return result;
}

/// Takes from a face's flux what diffusion sends through it: the difference of the potentials over the
/// distance along the normal, and where the line between the cells is not along the normal, the rest of the
/// gradient from the least squares of both.  Eq. (T36)
/// @return a bound of the diffusivity over the distance [m/s]
template <class Law, int D, int N>
[[nodiscard]] double add_diffusion(const Law& law, const FaceTables<D>& tables, const CellStates<N>& fields,
                                   Index number,
                                   std::array<double, static_cast<std::size_t>(N)>& flux) noexcept {
  const FaceCells<D>& face = tables.faces.data()[number];
  const Vector<D> normal = tables.normal(number);
  const Vector<D> between = face.from_owner - face.from_neighbour;
  const double per_distance = 1 / dot<D>(between, normal);
  const Vector<D> rest = normal - per_distance * between;
  const auto left = fields[face.owner];
  const auto right = fields[face.neighbour];
  const auto potential_left = law.potential(left);
  const auto potential_right = law.potential(right);
  for_each_component<N>(
      [&](std::size_t k) { flux[k] -= (potential_right[k] - potential_left[k]) * per_distance; });
  if (rest.squaredNorm() > round_off) {
    const auto rest_left = derivative_along<Law, D, N>(law, tables, fields, face.owner, rest);
    const auto rest_right = derivative_along<Law, D, N>(law, tables, fields, face.neighbour, rest);
    for_each_component<N>([&](std::size_t k) { flux[k] -= 0.5 * (rest_left[k] + rest_right[k]); });
  }
  return law.max_diffusivity(left, right) * per_distance;
}

}  // namespace scree::transport::detail
