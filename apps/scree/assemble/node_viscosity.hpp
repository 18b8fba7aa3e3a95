#pragma once

#include "scree/scene/scene.hpp"

#include <scree/mpm/step.hpp>

#include <string>
#include <string_view>

namespace scree::app {

/// Column that implicit viscosity adds: what a point had in the last step [Pa s].
inline constexpr std::string_view viscosity_column = "implicit_viscosity";

/// Makes viscosity implicit if the scene says so, or leaves it to us and explicit steps would be much
/// shorter: takes it out of the stress of the points, and gives the nodes what solves for it.  Eq. (M29)
/// @returns a sentence for the user on what was chosen and why; empty if the scene chose.
/// @throws InputError if this program was built without rheology_stiff.
template <int D, int V>
[[nodiscard]] std::string choose_viscosity(const Scene& scene, const CartesianGrid<D>& grid,
                                           mpm::Particles<D, V>& particles, mpm::Stages<D, V>& stages,
                                           Threads threads);

}  // namespace scree::app
