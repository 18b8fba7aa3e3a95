#include <scree/mpm/time_step.hpp>

#include <cmath>
#include <limits>

namespace scree::mpm {

template <int D>
TimeStep stable_time_step(const CartesianGrid<D>& grid, const Rates& rates, const TimeStepOptions& options) {
  for (const double share : {options.acoustic, options.advective, options.viscous, options.relaxation}) {
    require(0 < share && share <= 1, "TimeStepOptions: each share of a limit must lie in (0, 1]");
  }
  const double inverse_squares = grid.spacing().cwiseInverse().squaredNorm();
  TimeStep step{std::numeric_limits<double>::infinity(), Limit::maximum};
  const auto bound = [&](double dt, Limit limit) {
    if (dt < step.dt) step = {dt, limit};
  };
  bound(options.acoustic / (rates.wave_speed * std::sqrt(inverse_squares) + rates.advection_rate),
        Limit::acoustic);
  bound(options.advective / rates.advection_rate, Limit::advective);
  bound(options.viscous / (2 * rates.kinematic_viscosity * inverse_squares), Limit::viscous);
  bound(options.relaxation / rates.relaxation_rate, Limit::relaxation);
  if (options.maximum > 0) bound(options.maximum, Limit::maximum);
  require(std::isfinite(step.dt) && step.dt > 0, "stable_time_step: nothing bounds the step; give a maximum");
  return step;
}

template TimeStep stable_time_step(const CartesianGrid<1>&, const Rates&, const TimeStepOptions&);
template TimeStep stable_time_step(const CartesianGrid<2>&, const Rates&, const TimeStepOptions&);
template TimeStep stable_time_step(const CartesianGrid<3>&, const Rates&, const TimeStepOptions&);

}  // namespace scree::mpm
