#pragma once

#include <scree/transport/cell_states.hpp>
#include <scree/transport/components.hpp>
#include <scree/transport/detail/patch.hpp>

#include <array>

namespace scree::transport::detail {

/// The derivative of a law's potential along a vector, by the least-squares gradient of a cell.  Eq. (T32a)
template <class Law, int D, int N>
[[nodiscard]] std::array<double, static_cast<std::size_t>(N)> derivative_along(
    const Law& law, const Patch<D>& patch, const CellStates<N>& states, Index cell,
    const Vector<D>& direction) noexcept {
  const Vector<D> corrected = patch.corrections.data()[cell].transpose() * direction;
  const auto here = law.potential(states[cell]);
  std::array<double, static_cast<std::size_t>(N)> result{};
  for (const StencilCell<D>& near : patch.stencil_of(cell)) {
    const auto there = law.potential(states[near.cell]);
    double weight = 0;
    for_each_component<D>([&](std::size_t d) {
      weight += static_cast<double>(near.weight[d]) * corrected[static_cast<int>(d)];
    });
    for_each_component<N>([&](std::size_t k) { result[k] += weight * (there[k] - here[k]); });
  }
  return result;
}

/// Takes from a face's flux what diffusion sends through it: the difference of the potentials over the
/// distance along the normal, and where the line between the cells is not along the normal, the rest of the
/// gradient from the least squares of both.  Eq. (T36)
/// @return a bound of the diffusivity over the distance [m/s]
template <class Law, int D, int N>
[[nodiscard]] double add_diffusion(const Law& law, const Patch<D>& patch, const CellStates<N>& states,
                                   Index number,
                                   std::array<double, static_cast<std::size_t>(N)>& flux) noexcept {
  const FaceCells<D>& face = patch.ends.data()[number];
  const Vector<D>& normal = patch.normals.data()[number];
  const double per_distance = 1 / dot<D>(face.between, normal);
  const Vector<D> rest = normal - per_distance * face.between;
  const auto left = states[face.owner];
  const auto right = states[face.neighbour];
  const auto potential_left = law.potential(left);
  const auto potential_right = law.potential(right);
  for_each_component<N>(
      [&](std::size_t k) { flux[k] -= (potential_right[k] - potential_left[k]) * per_distance; });
  if (rest.squaredNorm() > round_off) {
    const auto rest_left = derivative_along<Law, D, N>(law, patch, states, face.owner, rest);
    const auto rest_right = derivative_along<Law, D, N>(law, patch, states, face.neighbour, rest);
    for_each_component<N>([&](std::size_t k) { flux[k] -= 0.5 * (rest_left[k] + rest_right[k]); });
  }
  return law.max_diffusivity(left, right) * per_distance;
}

}  // namespace scree::transport::detail
