#pragma once

#include "scree/filling.hpp"
#include "scree/scene.hpp"

#include <scree/mpm/particles.hpp>
#include <scree/mpm/step.hpp>

#include <string>

namespace scree::app {

/// Checks that no wave of sound and viscosity along an axis of the mesh grows in the first step on points as
/// they lie, and says which share of the limits would do. Waves across the mesh are left to the limits
/// themselves.  @see mpm::critical_sums(), Eqs. (M17), (M19)
/// @throws InputError naming the key of [numerics], the largest that it may be, and the critical step.
template <int D, int V>
void require_stable_step(const Scene& scene, const mpm::State<D, V>& state);

/// Checks that the law is stiff against the material's own weight. With p = K (rho/rho_0 - 1) a column of
/// height H is exp(rho_0 g H/K) times as dense at its base: e times if the ratio is 1.
/// @throws InputError naming the modulus and what it must exceed, if the ratio reaches 1.
template <int D, int V>
void require_stiff(const Scene& scene, const Filling<D>& filling, const mpm::Stages<D, V>& stages,
                   const mpm::Particles<D, V>& particles);

/// What to say of points at the start that are denser by a factor of exp(1/10) or more than their law's own
/// density, as under a tenth of the bulk modulus; else nothing.  Eq. (M187)
template <int D, int V>
[[nodiscard]] std::string softness_warning(const Scene& scene, const mpm::Particles<D, V>& particles);

}  // namespace scree::app
