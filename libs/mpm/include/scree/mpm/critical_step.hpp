#pragma once

#include <scree/mpm/shapes.hpp>
#include <scree/mpm/step.hpp>
#include <scree/mpm/transfers.hpp>

namespace scree::mpm {

/// Along each axis, the largest sum
///
///   (c dt/h)^2 + 8/3 nu dt/h^2
///
/// with which no wave of compression along that axis grows, sound and viscosity alike: the least over wave
/// numbers, with what points at these places give to a node and take from it in the mean by mass [-]. Exact
/// where points form a lattice along the mesh; nodes of little mass have less, means over cells more. Waves
/// across the mesh are not seen: in two and three dimensions theirs may be lower, which is left to (M17) and
/// (M19). Places are taken to a thousandth of a cell. Takes a pass over the points for each axis: for when a
/// run is assembled, and now and then.
/// @param xpic_order of the filter of velocities, of PicFlip with all of the increment; 0: there is none
/// @throws InputError naming a point without a finite position, or if no point has mass, or velocities are
/// filtered under another transfer.
/// @see Eqs. (M173), (M174), (M182)
template <int D, int V>
[[nodiscard]] Vector<D> critical_sums(const Particles<D, V>& particles, const CartesianGrid<D>& grid,
                                      const AnyShape& shape, const AnyTransfer& transfer, Order order,
                                      int xpic_order = 0);

/// No shape, transfer, order and place of points has a critical sum along an axis below this [-].  Eq. (M174)
inline constexpr double least_critical_sum = 0.5;

/// The step at which the sum along an axis reaches what critical_sums() has found [s]; infinite without sound
/// and viscosity, and no number if one of them or a sum is none. Of waves along the axes alone.  Eq. (M173)
template <int D>
[[nodiscard]] double critical_step(const Vector<D>& sums, const CartesianGrid<D>& grid,
                                   const Rates& rates) noexcept;

/// A step beyond which waves along an axis grow, however sound and viscosity differ from point to point [s]:
/// by the mean over points of what each adds to a wave's stiffness where it lies. Never less than
/// critical_step() of the largest rates, State::rates, and that if all points have them. Infinite without
/// sound and viscosity. Of waves that all nodes take part in, those that walls hold too; derived for points
/// of equal mass in a lattice, and under Apic and Order::usl for any; else found, and but for Order::usl not
/// where points lie in pairs, which may bear more; not under means over cells, Averaging, but for both of
/// them on Linear. Takes a pass over the points for each axis.  Eq. (M199)
/// @throws InputError naming a point without a finite position, or if velocities are filtered under another
/// transfer than PicFlip with all of the increment.
template <int D, int V>
[[nodiscard]] double unstable_step(const Particles<D, V>& particles, const StressUpdate<D, V>& stress,
                                   const CartesianGrid<D>& grid, const AnyShape& shape,
                                   const AnyTransfer& transfer, Order order, int xpic_order = 0);

/// For each step of a run whose steps are not those of stable_time_step(), or at large shares of its limits:
/// a few operations, with the rates that the last step has left. These are the largest of all points, so that
/// where a few are much faster than the rest the critical step is on the safe side. A longer step is unstable
/// along an axis; a shorter one may still be across the mesh, where (M17) and (M19) bind.
/// @param sums from critical_sums()
/// @throws InputError naming dt [s], the critical step, the limit that asks for most of it, and the point
/// where sound or viscosity is largest, if dt is longer, or one of the two is not a number.
template <int D, int V>
void require_stable(const State<D, V>& state, const Stages<D, V>& stages, const Vector<D>& sums, double dt);

}  // namespace scree::mpm
