#pragma once

#include <functional>
#include <optional>

namespace scree {

/// Density at which material at rest bears a pressure [kg/m^3]: by the secant rule, which needs one step for
/// a linear equation of state; where that leads nowhere, as from densities at which nothing is borne, by
/// bisection between one that bears too little and one that bears too much. Where a range of densities bears
/// no pressure and none is wanted, its end, at which grains touch.
/// @param excess pressure at a density over the one that is wanted [Pa], or what grows with it; it does not
/// fall
/// @param start density to begin with [kg/m^3], positive
/// @returns nothing if no density is found: by bisection, none from a third to three times of the start.
[[nodiscard]] std::optional<double> rest_density(const std::function<double(double)>& excess, double start);

}  // namespace scree
