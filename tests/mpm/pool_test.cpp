// Water at rest on a bed that cuts the mesh obliquely: which nodes hold it, and how rough it must be.

#include "bodies.hpp"
#include "dry_wall.hpp"

#include <scree/mpm/boundaries/bed.hpp>
#include <scree/mpm/geostatic.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace scree::mpm {
namespace {

constexpr Threads one_thread{1};
constexpr double degree = std::numbers::pi / 180;
constexpr double gravity = 9.81;  // [m/s^2]

/// The points of those `particles` that lie above a surface.
template <int D, int V>
void keep_above(Particles<D, V>& particles, const AnySurface<D>& surface) {
  std::vector<Index> above;
  for (Index p = 0; p < particles.size(); ++p) {
    Vector<D> x;
    for (int axis = 0; axis < D; ++axis) x[axis] = particles.position.component(axis)[p];
    if (surface(x).distance > 0) above.push_back(p);
  }
  particles.for_each_column([&](Column& column) { column.reorder(above); });
}

/// The largest share of its pressure that a bed had to bear as friction, to hold all that touched it.
struct Needed {
  static constexpr std::string_view name = "needed";
  template <class Real>
  struct Input {};
  static constexpr std::array<InputColumn, 0> inputs{};

  double* share;

  template <class Real>
  [[nodiscard]] Real traction(const Real&, const Real&, const Input<Real>&) const noexcept {
    return 0;
  }
  template <class Real>
  [[nodiscard]] Real slowed(const Real& speed, const WallContact<Real>& contact,
                            const Input<Real>&) const noexcept {
    *share = std::max(*share, speed / (contact.mobility * contact.pressure));
    return 0;
  }
};
static_assert(WallLaw<Needed>);

/// Water that rests on a bed at 20 degrees between two smooth walls.
template <class Law>
struct Basin {
  static constexpr double depth = 1.4;         // [m]
  static constexpr double compression = 1e-3;  // rho g H/K
  static constexpr Index num_cells = 20;
  static constexpr double spacing = 0.1;
  static constexpr Fluid water{1000 * gravity * depth / compression, 1000, 0};

  explicit Basin(const Law& law, const AnyShape& shape = Linear{}, double lowered = 0) {
    const auto grid = cube<2>(num_cells, spacing, false);
    const Vector<2> normal{-std::sin(20 * degree), std::cos(20 * degree)};
    const Vector<2> foot{0, 0.137};
    auto particles = seed_box<2, 2>(grid, Vector<2>{0, 0}, Vector<2>{2, depth}, {2, 2}, 1000);
    keep_above<2>(particles, PlaneSurface<2>{foot, normal});
    stages = stages_of<2, 2>(particles, shape, Apic{}, water);
    stages.gravity = {0, -gravity};
    for (const Side side : {Side::low, Side::high})
      stages.boundaries.push_back(make_wall<2>(Slip{}, 0, side));
    const PlaneSurface<2> bed{foot - lowered * normal, normal};
    stages.boundaries.push_back(make_bed<2>(Contact<Law>{law}, grid, bed));
    set_geostatic(particles, *stages.stress, 1, depth, gravity);
    state = std::make_unique<State<2, 2>>(start(std::move(particles), grid, stages, one_thread));
  }
  /// Largest speed on the way of `num_steps`, over that of sound.
  [[nodiscard]] double unrest(int num_steps) {
    const double dt = stable_time_step(state->nodes.grid(), state->rates, {}).dt;
    double fastest = 0;
    for (int n = 0; n < num_steps; ++n) {
      step(*state, stages, dt, one_thread);
      fastest = std::max(fastest, largest(state->particles.velocity));
    }
    return fastest / state->rates.wave_speed;
  }
  /// Error of the pressure, over that at the bottom.
  struct PressureError {
    double rms = 0;
    double worst = 0;
  };
  [[nodiscard]] PressureError pressure_error() const {
    PressureError error;
    const auto& particles = state->particles;
    double num_points = 0;
    for (Index p = 0; p < particles.size(); ++p) {
      if (!(particles.mass.component(0)[p] > 0)) continue;
      const double rest = 1000 * gravity * (depth - particles.position.component(1)[p]);
      const double off = (-particles.stress.component(0)[p] - rest) / (1000 * gravity * depth);
      error.rms += off * off;
      error.worst = std::max(error.worst, std::abs(off));
      ++num_points;
    }
    return {std::sqrt(error.rms / num_points), error.worst};
  }
  Stages<2, 2> stages;
  std::unique_ptr<State<2, 2>> state;
};

/// What the compression of a cell leaves out of balance, its square, and rounding as in a column at rest.
[[nodiscard]] double rest(int num_steps) {
  const double per_cell = 1e-3 / 14;
  return 2 * num_steps * round_off + per_cell * per_cell;
}

TEST(PoolOnABed,
     IsAtRestOnABedThatCutsTheMeshObliquely) {  // the nodes that feel its pressure are those it holds
  constexpr int num_steps = 200;
  Basin<Sticks> pool{Sticks{}};
  EXPECT_LE(pool.unrest(num_steps), rest(num_steps));
  EXPECT_LE(pool.pressure_error().worst, 1e-3 + 1e-3);  // of the density's, and as much of the mesh's
}

/// Where it fails: points fill the cells that a bed cuts in steps, so that their pressure pushes along it
/// too. A bed bears that up to its friction; smoother ones let material go, and then their pressure rings.
TEST(PoolOnABed, IsAtRestFromAFrictionThatCanBeTold) {
  constexpr int num_steps = 100;
  double share = 0;
  Basin<Needed> probe{Needed{&share}};
  static_cast<void>(probe.unrest(1));
  EXPECT_NEAR(share, 0.49, 0.005);

  Basin<Dry> rough{Dry{1.05 * share}};
  Basin<Dry> smooth{Dry{0.95 * share}};

  EXPECT_LE(rough.unrest(num_steps), rest(num_steps));
  EXPECT_GT(smooth.unrest(num_steps), 10 * rest(num_steps));
}

/// Below it the pool rings, the more the smoother the bed; as printed.
TEST(PoolOnABed, RingsOnASmootherBedMoreAndMore) {
  const auto expect_ringing = [](double friction, double expected) {
    Basin<Dry> pool{Dry{friction}};
    static_cast<void>(pool.unrest(200));
    const double ringing = pool.pressure_error().rms;
    static_cast<void>(pool.unrest(200));

    EXPECT_NEAR(ringing, expected, 0.005);
    EXPECT_GT(pool.pressure_error().rms, ringing);
  };

  expect_ringing(0.3, 0.07);
  expect_ringing(0, 0.13);
}

/// A number as it is printed, known to half of its last digit.
struct Printed {
  double value;
  double last_digit;
};
struct HeldUpTo {
  double share;  ///< of the reach of (M61)
  Printed rms;
  Printed worst;
};

/// The error of the pressure after 200 steps on a bed that holds the nodes up to a share of the reach of
/// (M61), as the documents print it, to half of the last digit. Friction is in proportion to what is stopped,
/// so that a bed which is lowered or raised is one that holds fewer or more nodes, and no more.
TEST(PoolOnABed, IsAtRestIfAllNodesAreHeldThatFeelTheBed) {  // Eq. (M61)
  const double reach = Basin<Dry>::spacing * (std::sin(20 * degree) + std::cos(20 * degree));
  const auto expect_errors = [&](const AnyShape& shape, const std::vector<HeldUpTo>& rows) {
    for (const HeldUpTo& row : rows) {
      Basin<Dry> pool{Dry{0.5}, shape, (1 - row.share) * reach};

      static_cast<void>(pool.unrest(200));

      const auto error = pool.pressure_error();
      EXPECT_NEAR(error.rms, row.rms.value, row.rms.last_digit / 2) << row.share;
      EXPECT_NEAR(error.worst, row.worst.value, row.worst.last_digit / 2) << row.share;
    }
  };

  expect_errors(Linear{}, {{0, {0.56, 0.01}, {3.9, 0.1}},
                           {0.5, {0.04, 0.01}, {0.42, 0.01}},
                           {1, {1e-4, 1e-4}, {4e-4, 1e-4}},
                           {1.5, {1e-4, 1e-4}, {4e-4, 1e-4}}});
  expect_errors(Quadratic{}, {{0, {0.43, 0.01}, {3.7, 0.1}},
                              {0.5, {0.07, 0.01}, {0.60, 0.01}},
                              {1, {0.002, 1e-3}, {0.02, 0.01}},
                              {1.5, {0.001, 1e-3}, {0.004, 1e-3}}});
}

/// Where it would fail: a bed that holds only nodes below it does not bear the pressure of the others.
TEST(PoolOnABed, WouldNotBeBorneByTheNodesBelowTheBedAlone) {
  const double reach = Basin<Sticks>::spacing * (std::sin(20 * degree) + std::cos(20 * degree));
  Basin<Sticks> lowered{Sticks{}, Linear{}, reach};

  static_cast<void>(lowered.unrest(200));

  EXPECT_GT(lowered.pressure_error().worst, 1);
}

/// Where it fails: quadratic shapes reach half a cell further than hats. A plane a cell away takes the share
/// 1/2 (3/2 - 1)^2 = 1/8 of what a node there feels.
TEST(PoolOnABed, LeavesNodesBeyondTheBedATailOfThePressureUnderQuadraticShapes) {
  Basin<Sticks> linear{Sticks{}};
  Basin<Sticks> quadratic{Sticks{}, Quadratic{}};

  static_cast<void>(linear.unrest(200));
  static_cast<void>(quadratic.unrest(200));
  EXPECT_GT(quadratic.pressure_error().worst, linear.pressure_error().worst);
  EXPECT_LE(quadratic.pressure_error().worst, 1.0 / 8);
}

}  // namespace
}  // namespace scree::mpm
