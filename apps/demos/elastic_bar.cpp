// A bar between two walls rings: v = v_0 cos(c k t) sin(k x), k = pi/L.                          Eq. (M85)
//
// The speed of sound is not told to the scheme: it follows from stress and mass, and comes out a little low,
// by a share of (k h)^2: second order. Of quadratic shapes under apic that share is 0.11 with two points a
// cell (Eq. M86), so that 40 cells are right to a thousandth.
#include "elastic.hpp"
#include "output.hpp"

#include <scree/mpm/seed.hpp>
#include <scree/mpm/step.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

using namespace scree;
using namespace scree::mpm;

namespace {

constexpr demo::Elastic bar{.bulk_modulus = 1e6, .shear_modulus = 0, .density = 1000};
constexpr double velocity = 1e-6;       // v_0 [m/s]: as good as linear
constexpr double k = std::numbers::pi;  // of a bar of 1 m [1/m]
constexpr int steps_per_period = 400;
constexpr Threads threads{1};
const double dt = 2 / bar.wave_speed() / steps_per_period;  // [s]

/// The share of sin(k x) in the velocities, over v_0, at each step of five periods.
demo::Column ring(Index num_cells) {
  const Vector<1> spacing{1 / static_cast<double>(num_cells)};
  const CartesianGrid<1> grid{Vector<1>{0.0}, spacing, {num_cells}, {false}};
  auto points = seed_box<1, 1>(grid, Vector<1>{0.0}, Vector<1>{1.0}, {2}, bar.density);
  for (Index p = 0; p < points.size(); ++p) {
    const double x = points.position.component(0)[p];
    points.velocity.component(0)[p] = velocity * std::sin(k * x);
    points.velocity_gradient.component(0)[p] = velocity * k * std::cos(k * x);
  }
  Stages<1, 1> stages;
  stages.stress = std::make_unique<StressUpdateBy<1, 1, demo::Elastic>>(bar, points);
  stages.transfer = make_transfer<1, 1>(Quadratic{}, Apic{});
  for (const Side side : {Side::low, Side::high}) stages.boundaries.push_back(make_wall<1>(Slip{}, 0, side));
  auto state = start(std::move(points), grid, stages, threads);
  demo::Column share{"cells_" + std::to_string(num_cells), {}};
  for (int n = 0; n <= 5 * steps_per_period; ++n) {
    double sum = 0;  // points that only fill up blocks have no mass
    const auto& p = state.particles;
    for (Index i = 0; i < p.size(); ++i) {
      if (p.mass.component(0)[i] > 0)
        sum += std::sin(k * p.position.component(0)[i]) * p.velocity.component(0)[i];
    }
    share.values.push_back(sum / (velocity * static_cast<double>(num_cells)));
    step(state, stages, dt, threads);
  }
  return share;
}

/// How much too slowly it rings [-], from when it falls through zero in the fifth period.
double lag(const demo::Column& ringing) {
  std::size_t n = 9 * steps_per_period / 2;  // 0.02 periods before and after 4.25 are searched with ease
  n -= steps_per_period / 2;
  while (ringing.values[n] > 0 || ringing.values[n - 1] <= 0) ++n;
  const double before = ringing.values[n - 1];
  const double steps = static_cast<double>(n - 1) + before / (before - ringing.values[n]);
  return (steps + 0.5) / (4.25 * steps_per_period) - 1;  // strain is half a step behind the first velocity
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<demo::Column> table{{"period", {}}, {"theory", {}}};
  for (const Index num_cells : {10, 20, 40}) table.push_back(ring(num_cells));
  for (std::size_t n = 0; n < table[2].values.size(); ++n) {
    table[0].values.push_back(static_cast<double>(n) / steps_per_period);
    table[1].values.push_back(std::cos(2 * std::numbers::pi * table[0].values.back()));
  }
  demo::write_table(demo::folder_from(argc, argv) / "elastic_bar.csv", table);
  const double order = std::log2(lag(table[3]) / lag(table[4]));
  std::printf("20 and 40 cells ring too slowly by %.2e and %.2e: order %.2f\n", lag(table[3]), lag(table[4]),
              order);
  return std::abs(order - 2) < 0.1 && std::abs(lag(table[4])) < 1e-3 ? 0 : 1;
}
