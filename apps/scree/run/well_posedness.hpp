#pragma once

#include "scree/scene/scene.hpp"

#include <optional>
#include <string>

namespace scree::app {

/// Remixing below which the scene's two-way coupling is ill-posed [m^2/s], estimated for steady flow at its
/// base from the initial mixture: D_crit = c (s_a - s_h) times the rate at which the closure's drive falls as
/// s_a grows at fixed shear stress. Zero or less if it is well posed without. Nothing if the scene has no
/// segregation, no flow, or no viscosity.  Eq. (G12)
[[nodiscard]] std::optional<double> critical_remixing(const Scene& scene);

/// What to tell the user of an ill-posed scene; empty if there is nothing to tell.
[[nodiscard]] std::string ill_posedness_warning(const Scene& scene);

}  // namespace scree::app
