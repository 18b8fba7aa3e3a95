// A column of water collapses: its front beside that of an experiment, Martin and Moyce 1952.
//
// Water twice as high as wide is let go in a smooth tank, by a stiff fluid that bears no tension. It slides
// without friction, and its dam is gone at once: it is ahead of the experiment, by less than an eighth.
#include "output.hpp"

#include <scree/constitutive_law.hpp>
#include <scree/mpm/boundaries.hpp>
#include <scree/mpm/seed.hpp>
#include <scree/mpm/step.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace scree;
using namespace scree::mpm;

namespace {
constexpr double g = 9.81;                       // [m/s^2]
constexpr double width = 1;                      // of the column; it is twice as high [m]
constexpr Index num_cells = 20;                  // along its width
const double unit = std::sqrt(width / (2 * g));  // of time [s]
constexpr Threads threads{1};

/// p = K (rho/rho_0 - 1), nothing in tension. How a law is written is the idea of `own_law`.
struct Water {
  static constexpr std::string_view name = "water";
  template <class Real>
  struct Input {};
  static constexpr std::array<InputColumn, 0> inputs{};
  template <class Real>
  struct State {};
  static constexpr std::array<StateColumn, 0> states{};
  double bulk_modulus = 4e6;  // K [Pa]: sound ten times as fast as a fall from the top
  double density = 1000;      // rho_0 [kg/m^3]

  template <class Real>
  [[nodiscard]] Response<Real, State<Real>> update(const Deformation<Real>& deformation, const Input<Real>&,
                                                   const State<Real>&, Real) const noexcept {
    const Real compression = deformation.density / density - 1;
    return {isotropic(-bulk_modulus * select(compression > 0, compression, Real(0))), {}};
  }
  [[nodiscard]] Stiffness<double> stiffness(const Deformation<double>&, const Input<double>&,
                                            const State<double>&) const noexcept {
    return {std::sqrt(bulk_modulus / density), 0};
  }
};
static_assert(ConstitutiveLaw<Water>);

/// Where the front was seen, in widths, and when, in (width/(2 g))^(1/2).
struct Seen {
  double time, place;
};
constexpr std::array<Seen, 5> experiment{
    {{0.84, 1.22}, {1.19, 1.44}, {1.98, 2.33}, {2.51, 3.00}, {3.33, 4.11}}};

/// The place behind which are 99.5 % of the points: the toe is thinner than a cell [m].
double front_of(const Particles<2>& water) {
  std::vector<double> x;
  for (Index p = 0; p < water.size(); ++p) {
    if (water.mass.component(0)[p] > 0) x.push_back(water.position.component(0)[p]);
  }
  std::ranges::sort(x);
  return x[x.size() * 995 / 1000];
}
}  // namespace

int main(int argc, char** argv) {
  const double h = width / num_cells;
  const CartesianGrid<2> grid{{0, 0}, {h, h}, {6 * num_cells, 3 * num_cells}, {false, false}};
  auto water = seed_box<2, 2>(grid, Vector<2>{0, 0}, Vector<2>{width, 2 * width}, {2, 2}, 1000);
  Stages<2, 2> stages;
  stages.stress = std::make_unique<StressUpdateBy<2, 2, Water>>(Water{}, water);
  stages.transfer = make_transfer<2, 2>(Quadratic{}, Apic{});
  stages.gravity = {0, -g};
  for (const int axis : {0, 1}) {
    for (const Side side : {Side::low, Side::high})
      stages.boundaries.push_back(make_wall<2>(Slip{}, axis, side));
  }
  auto state = start(std::move(water), grid, stages, threads);
  std::vector<demo::Column> seen{{"time", {}}, {"experiment", {}}, {"front", {}}};
  double time = 0;  // [s]
  double lead = 0;  // the largest, over the place itself [-]
  for (const Seen& sight : experiment) {
    while (time < sight.time * unit) {
      const double dt = std::min(stable_time_step(grid, state.rates, {}).dt, sight.time * unit - time);
      step(state, stages, dt, threads);
      time += dt;
    }
    const double front = front_of(state.particles) / width;
    lead = std::max(lead, std::abs(front / sight.place - 1));
    seen[0].values.push_back(sight.time);
    seen[1].values.push_back(sight.place);
    seen[2].values.push_back(front);
  }
  demo::write_table(demo::folder_from(argc, argv) / "water_column.csv", seen);
  std::printf("the front is within %.0f %% of where it was seen\n", 100 * lead);
  return lead < 1.0 / 8 ? 0 : 1;
}
