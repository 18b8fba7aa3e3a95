// A block falls, and nothing else happens to it.
//
//   v' = g,   x' = v                                                               Eqs. (M11), (M12)
//
// What falls freely must not feel the mesh through which it falls: no stress, no turn, no change of form,
// whichever cells its points are in. Then points move as one body does under the step itself, velocity first:
// v = g t, to round-off, and a way of g t (t + dt)/2, where theory has g t^2/2.
#include "elastic.hpp"
#include "output.hpp"

#include <scree/mpm/seed.hpp>
#include <scree/mpm/step.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

using namespace scree;
using namespace scree::mpm;

namespace {

constexpr double g = 9.81;         // [m/s^2]
constexpr double spacing = 0.25;   // [m]
constexpr double dt = 1.0 / 1024;  // [s]
constexpr int num_steps = 1000;
constexpr Threads threads{1};

}  // namespace

int main(int argc, char** argv) {
  const auto folder = demo::folder_from(argc, argv);
  const CartesianGrid<2> grid{Vector<2>{0, 0}, Vector<2>{spacing, spacing}, {12, 32}, {false, false}};
  auto block = seed_box<2, 2>(grid, Vector<2>{1, 6}, Vector<2>{2, 7}, {2, 2}, 1000);
  Stages<2, 2> stages;
  stages.stress = std::make_unique<StressUpdateBy<2, 2, demo::Elastic>>(demo::Elastic{1e6, 5e5, 1000}, block);
  stages.transfer = make_transfer<2, 2>(Quadratic{}, Apic{});
  stages.gravity = {0, -g};
  auto state = start(std::move(block), grid, stages, threads);

  std::vector<demo::Column> fall{{"time", {}}, {"way", {}}, {"way_of_the_step", {}}, {"theory", {}}};
  double worst = 0;  // [m/s]
  const double first_height = state.particles.position.component(1)[0];
  const double first_id = state.particles.id.component(0)[0];
  for (int n = 1; n <= num_steps; ++n) {
    step(state, stages, dt, threads);
    const double t = n * dt;
    double way = 0;
    for (Index p = 0; p < state.particles.size(); ++p) {
      const double speed = -state.particles.velocity.component(1)[p];
      worst = std::max({worst, std::abs(speed - g * t), std::abs(state.particles.velocity.component(0)[p])});
      if (state.particles.id.component(0)[p] == first_id) {
        way = first_height - state.particles.position.component(1)[p];
      }
    }
    const std::array<double, 4> row{t, way, g * t * (t + dt) / 2, g * t * t / 2};
    for (std::size_t k = 0; k < row.size(); ++k) fall[k].values.push_back(row[k]);
  }
  demo::write_table(folder / "free_fall.csv", fall);
  const double way_error = std::abs(fall[1].values.back() - fall[2].values.back());
  std::printf("after %.3f s: way %.6f m, by the step %.6f m; speeds are off by %.1e m/s at most\n",
              num_steps * dt, fall[1].values.back(), fall[2].values.back(), worst);
  // A step rounds each velocity some 50 times (9 nodes of 5 sums), of speeds up to g t; a way adds them up.
  const double rounding = num_steps * 50 * round_off * g * num_steps * dt;
  return worst < rounding && way_error < rounding ? 0 : 1;
}
