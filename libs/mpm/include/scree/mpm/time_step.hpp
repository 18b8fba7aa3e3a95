#pragma once

#include <scree/grid.hpp>

#include <array>
#include <string_view>

namespace scree::mpm {

/// What the material bounds a step by, over all points.
struct Rates {
  double wave_speed = 0;           ///< largest [m/s]
  double kinematic_viscosity = 0;  ///< largest [m^2/s]
  double advection_rate = 0;       ///< largest sum over axes of |v_d| / spacing_d [1/s]
  double relaxation_rate = 0;      ///< fastest change of a law's memory that it does not solve for [1/s]
};

/// The share of each limit that is used; all in (0, 1].
struct TimeStepOptions {
  double acoustic = 0.5;    ///< of the time in which sound crosses a cell  [-], Eq. (M17)
  double advective = 0.2;   ///< of the time in which a point crosses a cell  [-], Eq. (M18)
  double viscous = 0.5;     ///< of the limit of explicit viscosity  [-], Eq. (M19)
  double relaxation = 0.5;  ///< of the time in which a law's memory changes  [-], Eq. (M25)
  double maximum = 0;       ///< the user's own limit [s]; 0 is none
};

/// What bound a step.
enum class Limit { acoustic, advective, viscous, relaxation, maximum, output };
inline constexpr std::array<std::string_view, 6> limit_names{"acoustic",   "advective", "viscous",
                                                             "relaxation", "maximum",   "output"};

struct TimeStep {
  double dt;    ///< [s]
  Limit limit;  ///< what bound it
};

/// The longest step that is stable, and why it is no longer.  Eqs. (M17)-(M19), (M25)
/// @throws InputError if nothing bounds it, or a share is outside (0, 1].
template <int D>
[[nodiscard]] TimeStep stable_time_step(const CartesianGrid<D>& grid, const Rates& rates,
                                        const TimeStepOptions& options);

}  // namespace scree::mpm
