// A collapse over a synthetic valley and a dam break of 1e5 points, both to their ends; minutes long.

#include "scenes.hpp"
#include "scree/ground.hpp"
#include "scree/simulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace scree::app::testing {
namespace {

/// Sums over all points.
struct Totals {
  double mass = 0;                         // [kg]
  Vector<3> centre = Vector<3>::Zero();    // [m]
  Vector<3> velocity = Vector<3>::Zero();  // of the centre [m/s]
  double kinetic_energy = 0;               // [J]
  double least_distance = 1e300;           // to the ground, if there is one [m]
  std::vector<double> places;              // along x, in order [m]

  /// Behind it is this share of the points.
  [[nodiscard]] double front(double share) const {
    return places[static_cast<std::size_t>(share * static_cast<double>(places.size() - 1))];
  }
};

[[nodiscard]] Totals totals_of(const Simulation<3, 3>& simulation, const mpm::AnySurface<3>& ground = {}) {
  Totals totals;
  const auto& particles = simulation.state.particles;
  for (Index p = 0; p < particles.size(); ++p) {
    const double mass = particles.mass.component(0)[p];
    if (!(mass > 0)) continue;
    Vector<3> x;
    Vector<3> v;
    for (int d = 0; d < 3; ++d) {
      x[d] = particles.position.component(d)[p];
      v[d] = particles.velocity.component(d)[p];
    }
    totals.mass += mass;
    totals.centre += mass * x;
    totals.velocity += mass * v;
    totals.kinetic_energy += mass * v.squaredNorm() / 2;
    totals.places.push_back(x[0]);
    if (ground) totals.least_distance = std::min(totals.least_distance, ground(x).distance);
  }
  totals.centre /= totals.mass;
  totals.velocity /= totals.mass;
  std::sort(totals.places.begin(), totals.places.end());
  return totals;
}

TEST(ValleyCollapse, RunsOutOntoTheFanAndComesToRest) {
  Simulation<3, 3> valley{scene_of("valley_collapse"), {1}};
  const auto ground = surface_of<3>(*valley.scene().terrain, valley.scene().mesh);
  const Totals start = totals_of(valley, ground);
  double least_distance = start.least_distance;
  double fastest = 0;

  while (!valley.is_finished()) {
    if (!valley.step()) continue;
    const Totals now = totals_of(valley, ground);
    least_distance = std::min(least_distance, now.least_distance);
    fastest = std::max(fastest, now.velocity.norm());
  }

  const Totals end = totals_of(valley, ground);
  const double rounding = static_cast<double>(start.places.size()) * round_off;
  EXPECT_NEAR(end.mass + valley.state.absorbed.mass, start.mass, rounding * start.mass);
  // Velocity is smooth over the support of a shape function, 3 cells: where the ground is an arc, the path of
  // a point may be its chord. The valley's least radius is that of its trough, 60 m.
  const double chord = 3 * valley.grid().spacing()[0];
  EXPECT_GT(least_distance, -chord * chord / (8 * 60));
  EXPECT_GT(end.front(0.995), 110);  // onto the fan, which begins there
  EXPECT_GT(end.front(0.995) - start.front(0.995), 60);
  EXPECT_LT(end.velocity.norm(), 0.01 * fastest);
  // A block that slides down stops where it has fallen by friction times its way; what also shears within,
  // and has an inner friction of up to mu_2, sooner.
  const Vector<3> way = end.centre - start.centre;
  const double apparent_friction = -way[1] / std::hypot(way[0], way[2]);
  EXPECT_GT(apparent_friction, 0.4);
  EXPECT_LT(apparent_friction, 0.64);
}

TEST(DamBreak3d, RunsThroughTheTankToItsFarEnd) {
  constexpr double gravity = 9.81;
  constexpr double height = 0.65;
  Simulation<3, 3> dam{scene_of("dam_break_3d"), {2}};
  ASSERT_NEAR(static_cast<double>(dam.num_points()), 1e5, 1e3);
  const Totals start = totals_of(dam);
  const double energy = start.mass * gravity * start.centre[1];
  double arrival = 0;

  while (!dam.is_finished()) {
    if (!dam.step()) continue;
    const Totals now = totals_of(dam);
    if (arrival == 0 && now.front(0.999) > 1.95) arrival = dam.clock.time;
    // Compression stores less than (rho g H)^2/(2 K) of each volume, beside rho g H/2 of its fall.
    EXPECT_LT(now.kinetic_energy + now.mass * gravity * now.centre[1],
              energy * (1 + 1000 * gravity * height / 1.2e6));
  }

  const Totals end = totals_of(dam);
  EXPECT_EQ(end.places.size(), start.places.size());
  EXPECT_NEAR(end.mass, start.mass, 1e5 * round_off * start.mass);
  // Water that falls from H without loss runs at (2 g H)^(1/2), the front of a shallow layer at 2 (g
  // H)^(1/2).
  EXPECT_GT(arrival, 1.45 / (2 * std::sqrt(gravity * height)));
  EXPECT_LT(arrival, 1.45 / (std::sqrt(gravity * height) / 2));
}

}  // namespace
}  // namespace scree::app::testing
