#include "../cpu_time.hpp"
#include "mpm/manufactured_run.hpp"
#include "problems.hpp"

#include <scree/error.hpp>

#include <limits>

namespace scree::charts {

namespace {

/// On three meshes, each twice as fine as the last; quick: on the first.  @param unit of the errors [m]
template <class Motion>
[[nodiscard]] std::vector<Run> run_meshes(const std::string& problem, const Motion& motion, double unit,
                                          Index coarsest, const Scheme& scheme, bool is_quick) {
  std::vector<Run> runs;
  const Index finest = is_quick ? coarsest : 4 * coarsest;
  for (Index cells = coarsest; cells <= finest; cells *= 2) {
    Run run{problem, scheme, cells};
    const auto timed = [&](const auto& one_step) {
      const double start = cpu_seconds();
      one_step();
      run.cpu_seconds += cpu_seconds() - start;
    };
    try {
      mpm::ManufacturedRun<Motion> body{motion, cells, scheme.any_shape, scheme.any_transfer,
                                        mpm::Extras{.order = scheme.order,
                                                    .xpic_order = scheme.xpic_order,
                                                    .points_per_axis = scheme.points_per_axis}};
      run.error = body.error(timed) / unit;
    } catch (const RunError&) {  // points have left the mesh
      run.error = std::numeric_limits<double>::quiet_NaN();
    }
    runs.push_back(run);
  }
  return runs;
}

}  // namespace

std::vector<Run> swing(const Scheme& scheme, bool is_quick) {
  constexpr double amplitude = 0.02;  // [m], a strain of 13 %
  return run_meshes("swing", mpm::AxisAlignedSwing{amplitude}, amplitude, 8, scheme, is_quick);
}

std::vector<Run> turning_ring(const Scheme& scheme, bool is_quick) {
  constexpr double amplitude = 0.3;  // [rad]
  constexpr double radius = 0.275;   // [m], where it turns furthest
  return run_meshes("turning_ring", mpm::TurningRing{amplitude}, amplitude * radius, 16, scheme, is_quick);
}

}  // namespace scree::charts
