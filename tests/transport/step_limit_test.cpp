// Steps that collapse end an advance, which says where and when; steps that are merely many do not.

#include "lines.hpp"
#include "meshes.hpp"

#include <scree/transport/grids/rectilinear.hpp>
#include <scree/transport/integrators.hpp>
#include <scree/transport/laws/advection.hpp>
#include <scree/transport/laws/burgers.hpp>
#include <scree/transport/laws/user_law.hpp>
#include <scree/transport/limiters.hpp>
#include <scree/transport/staggered.hpp>

#include <gtest/gtest.h>

namespace scree::transport {
namespace {

const Advection<1> wind{Vector<1>{1.0}};

/// A source that raises u by one a second.
constexpr auto rise = [](const std::array<double, 1>&, const Vector<1>&, double) {
  return std::array<double, 1>{1.0};
};

/// No flux, but waves that are a million times as fast once u exceeds 0.99.
auto runaway() {
  return make_law<1, 1>(
      [](double, const Vector<1>&) { return 0.0; },
      [](double left, double right, const Vector<1>&) { return std::max(left, right) > 0.99 ? 1e6 : 1; });
}

/// Ten cells of 0.1, of which the fourth gives half of its width to the next one.
Rectilinear<1> uneven() {
  return Rectilinear<1>{{{{0, 0.1, 0.2, 0.3, 0.35, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0}}}};
}

TEST(StepLimit, EndsARunWhoseStepsCollapse) {
  std::vector<double> u(10, 0.0);
  Solver solver{uneven(), with_source(runaway(), rise), PiecewiseConstant{}, ForwardEuler{}, {.cfl = 0.5}};

  const auto message = test::message_of<RunError>([&] { solver.advance(u, 2); });

  // Steps of 0.5 x 0.05 s up to u = 1 after the 40th; then a million times as short, up to 1000 (2/0.025 +
  // 10) in all.
  EXPECT_EQ(
      message,
      "Solver: the time step fell from 0.025 s to 2.5e-08 s in 90000 steps, at time 1.00225 s: more steps "
      "than a flow of such waves as at the start takes; waves are fastest at site (3), position (0.325) m");
  EXPECT_EQ(u, std::vector<double>(10, 0.0));  // as it was
  EXPECT_EQ(solver.time(), 0);
}

TEST(StepLimit, IsNotMetByWavesThatStartAtRest) {  // no first step to compare with: a thousand crossings
  std::vector<double> u(10, 0.0);
  Solver solver{Cartesian<1>{test::line(10, 0, 1)}, with_source(Burgers{}, rise)};

  const Advance done = solver.advance(u, 20);  // u = t, a crossing takes 1/t

  EXPECT_GE(done.substeps, 3000);
  for (const double value : u) EXPECT_NEAR(value, 20, 20 * done.substeps * round_off);
}

TEST(StepLimit, MayBeSet) {  // 1/(0.5 x 0.1) = 20 steps
  std::vector<double> u(10, 1.0);
  const auto advance = [&](Index max_steps) {
    Solver{Cartesian<1>{test::line(10, 0, 1)},
           wind,
           PiecewiseConstant{},
           SspRk2{},
           {.cfl = 0.5, .max_steps = max_steps}}
        .advance(u, 1);
  };
  advance(20);
  EXPECT_EQ(test::message_of<RunError>([&] { advance(19); }),
            "Solver: the time step fell from 0.05 s to 0.05 s in 19 steps, at time 0.95 s: more steps than "
            "max_steps; waves are fastest at site (0), position (0.05) m");
  EXPECT_EQ(test::message_of<InputError>([&] { advance(0); }), "Solver: max_steps is 0: must be at least 1");
}

TEST(StepLimit, HoldsForTheStaggeredScheme) {  // 1/(0.25 x 0.1) = 40 steps, in pairs
  std::vector<double> u(10, 1.0);
  const auto advance = [&](Index max_steps) {
    StaggeredSolver{test::line(10, 0, 1), wind, Minmod{}, {.cfl = 0.25, .max_steps = max_steps}}.advance(u,
                                                                                                         1);
  };
  advance(40);
  EXPECT_EQ(test::message_of<RunError>([&] { advance(38); }),
            "Solver: the time step fell from 0.025 s to 0.025 s in 38 steps, at time 0.95 s: more steps than "
            "max_steps; waves are fastest at site (0), position (0.05) m");
}

TEST(StepLimit, NamesACellOfAPolygonalGrid) {
  const Polygonal grid{make_mesh({.count = {4, 1}, .cut = Cut::quadrilaterals, .is_periodic = {true, true}})};
  std::vector<double> u(4, 1.0);
  Solver solver{
      grid, Advection<2>{Vector<2>{1, 0}}, PiecewiseConstant{}, SspRk2{}, {.cfl = 0.5, .max_steps = 1}};
  EXPECT_EQ(test::message_of<RunError>([&] { solver.advance(u, 1); }),
            "Solver: the time step fell from 0.125 s to 0.125 s in 1 steps, at time 0.125 s: more steps than "
            "max_steps; waves are fastest at cell 0, position (0.125, 0.5) m");
}

TEST(StepLimit, SaysWhenTimeStandsStill) {
  std::vector<double> u(10, 1e200);
  Solver solver{Cartesian<1>{test::line(10, 0, 1)}, Advection<1>{Vector<1>{1e30}}, PiecewiseLinear{Minmod{}}};
  EXPECT_EQ(test::message_of<RunError>([&] { solver.advance(u, 1); }),
            "Solver: the time step fell from 6e-32 s to 6e-32 s in 1 steps, at time 0 s: below the "
            "round-off of "
            "the duration, 1 s; waves are fastest at site (0), position (0.05) m");
}

}  // namespace
}  // namespace scree::transport
