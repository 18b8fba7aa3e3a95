#pragma once

#include "scree/filling.hpp"
#include "scree/scene.hpp"

#include <scree/mpm/particles.hpp>
#include <scree/mpm/step.hpp>

namespace scree::app {

/// Checks that the first step lets no wave of sound grow. On points in the middle of their cells, h apart,
/// hat functions are central differences, and the shortest wave of compression stays bounded up to
///
///   (c dt/h)^2 + 8/3 nu dt/h^2 = 1
///
/// where points pass on their velocity gradient. Under pic_flip, whose points' velocities do not see that
/// wave, it is 1/2 with the order usl, Eq. (M17), and at least 2 with usf and musl.
/// @throws InputError naming the key of [numerics], the largest that it may be, and the critical step.
template <int D, int V>
void require_stable_step(const Scene& scene, const mpm::State<D, V>& state);

/// Checks that the law is stiff against the material's own weight. With p = K (rho/rho_0 - 1) a column of
/// height H is exp(rho_0 g H/K) times as dense at its base: e times if the ratio is 1.
/// @throws InputError naming the modulus and what it must exceed, if the ratio reaches 1.
template <int D, int V>
void require_stiff(const Scene& scene, const Filling<D>& filling, const mpm::Stages<D, V>& stages,
                   const mpm::Particles<D, V>& particles);

}  // namespace scree::app
