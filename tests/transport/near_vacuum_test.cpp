// A gas torn apart: which reconstructions survive, and from which speed on the others do not.

#include "gas_lines.hpp"

#include <scree/transport/reconstructions.hpp>

#include <gtest/gtest.h>

namespace scree::transport {
namespace {

using test::GasProblem;

const PiecewiseLinear mc{Minmod{2}};
const PiecewiseLinear minmod{Minmod{1}};
const InPrimitives primitive_mc{mc, Euler<1>{}};

using Line = PiecewiseLinear<Minmod>;
using PrimitiveLine = InPrimitives<Line, Euler<1>>;
/// Any of those that are tried: a solver of each flux is compiled once for all.
using Tried = AnyReconstruction<PiecewiseConstant, Line, PrimitiveLine, Admissible<Line, Euler<1>>,
                                Admissible<PrimitiveLine, Euler<1>>>;

/// (1, -v, 0.4) | (1, v, 0.4): fans that part, with vacuum between them from v = 3.74 on.
/// @return the message of the failure; empty if there is none
template <class F>
std::string parting(double speed, const Tried& reconstruction, const F& flux, double cfl) {
  const GasProblem problem{{1, -speed, 0.4}, {1, speed, 0.4}, 0.02};
  return test::message_of<RunError>([&] {
    auto u = test::conserved_line(problem, 200);
    auto options = test::open_ends();
    options.cfl = cfl;
    Solver<Cartesian<1>, Euler<1>, Tried, F> solver{
        Cartesian<1>{test::line(200, -0.5, 0.5, false)}, Euler<1>{}, reconstruction, SspRk2{}, options, flux};
    solver.advance(u, problem.time);
  });
}

template <class F>
class NearVacuum : public ::testing::Test {};
using Fluxes = ::testing::Types<KurganovTadmor, KurganovNoellePetrova>;
TYPED_TEST_SUITE(NearVacuum, Fluxes);

TYPED_TEST(NearVacuum, BreaksSlopesOfConservedVariables) {  // from v = 2 on, the whole message once
  EXPECT_EQ(parting(1, {minmod}, TypeParam{}, 0.4), "");
  for (const double speed : {2.0, 3.0, 5.0, 10.0}) {
    for (const double cfl : {0.4, 0.2}) {
      EXPECT_NE(parting(speed, {mc}, TypeParam{}, cfl), "") << speed << ' ' << cfl;
      EXPECT_NE(parting(speed, {minmod}, TypeParam{}, cfl), "") << speed << ' ' << cfl;
    }
  }
  EXPECT_EQ(parting(2, {mc}, TypeParam{}, 0.4),
            "transport: the rate of change is not finite at site (98), position (-0.0075) m");
}

TYPED_TEST(NearVacuum, LeavesFirstOrderStanding) {
  for (const double speed : {2.0, 3.7, 5.0, 10.0}) {
    EXPECT_EQ(parting(speed, {PiecewiseConstant{}}, TypeParam{}, 0.4), "") << speed;
  }
}

TYPED_TEST(NearVacuum, LeavesSlopesOfPrimitiveVariablesStanding) {
  for (const double speed : {2.0, 3.7, 5.0, 10.0}) {
    EXPECT_EQ(parting(speed, {primitive_mc}, TypeParam{}, 0.4), "") << speed;
    EXPECT_EQ(parting(speed, {InPrimitives{minmod, Euler<1>{}}}, TypeParam{}, 0.4), "") << speed;
  }
}

TYPED_TEST(NearVacuum, IsOvercomeByScalingSlopesDown) {  // promised, Eq. (T24); conserved slopes too
  for (const double speed : {2.0, 3.7, 5.0, 10.0, 30.0}) {
    EXPECT_EQ(parting(speed, {Admissible{mc, Euler<1>{}}}, TypeParam{}, 0.4), "") << speed;
    EXPECT_EQ(parting(speed, {Admissible{primitive_mc, Euler<1>{}}}, TypeParam{}, 0.4), "") << speed;
  }
}

}  // namespace
}  // namespace scree::transport
