#pragma once

#include "scree/assemble/filling.hpp"
#include "scree/scene/scene.hpp"

#include <scree/mpm/particles.hpp>
#include <scree/mpm/step.hpp>

#include <string>

namespace scree::app {

template <int D, int V>
class Simulation;

/// Checks that no wave of sound and viscosity along an axis of the mesh grows in the first step on points as
/// they lie, and says which share of the limits would do. Waves across the mesh are left to the limits
/// themselves.  @see mpm::critical_sums(), Eqs. (M17), (M19)
/// @throws InputError naming the key of [numerics], the largest that it may be, and the critical step.
template <int D, int V>
void require_stable_step(const Scene& scene, const mpm::State<D, V>& state);

/// What to say of a run on whose points, as they are by now, waves of sound and viscosity grow along an axis
/// of the mesh at the next step, the stable one by `state.rates`; else nothing. Not on the safe side, as a
/// run that goes on is not to be stopped without need: by what bounds waves in the mean of the points. It may
/// be so for a layer of some 0.4 cells or more whose nodes a wall holds. Nothing of runs with means over
/// cells that may bear more. Takes the passes of unstable_step() where not every scheme is stable: for now
/// and then.
/// @see mpm::unstable_step(), Eqs. (M174), (M199)
template <int D, int V>
[[nodiscard]] std::string instability(const Scene& scene, const mpm::State<D, V>& state,
                                      const mpm::StressUpdate<D, V>& stress);

/// What to say of a scene with one mean over cells and not the other: where points of a cell differ in
/// stiffness, waves may grow far below the critical step, and instability() does not look for them. Nothing
/// in one dimension on hat functions, whose points of a cell all see the same strain and weigh stress alike.
/// @see Eqs. (M131), (M132)
[[nodiscard]] std::string one_mean_warning(const Scene& scene);

/// What to add to the message of a step that failed, unless a point has left the mesh and none may: the key
/// of [numerics] that bounds steps. Empty if none does.
/// @param limit what bounds them
[[nodiscard]] std::string step_remedy(const Scene& scene, mpm::Limit limit);

/// Checks that the law is stiff against the material's own weight. With p = K (rho/rho_0 - 1) a column of
/// height H is exp(rho_0 g H/K) times as dense at its base: e times if the ratio is 1.
/// @throws InputError naming the modulus and what it must exceed, if the ratio reaches 1.
template <int D, int V>
void require_stiff(const Scene& scene, const Filling<D>& filling, const mpm::Stages<D, V>& stages,
                   const mpm::Particles<D, V>& particles);

/// What to say of points at the start that are denser by a factor of exp(1/10) or more than their law's own
/// density, as under a tenth of the bulk modulus; or, of points of a checkpoint, of those whose weight will
/// make them so, whatever law they come from; else nothing.  Eq. (M187)
template <int D, int V>
[[nodiscard]] std::string softness_warning(const Simulation<D, V>& simulation);

}  // namespace scree::app
