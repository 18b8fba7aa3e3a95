// Riemann problems of a gas against their exact solutions, and against tables of another code with the same
// limiter, CFL number and integrator. Its rule for the last step may differ: 3 %.

#include "gas_lines.hpp"

#include <scree/transport/reconstructions.hpp>

#include <gtest/gtest.h>

#include <array>

namespace scree::transport {
namespace {

using test::GasProblem;
using test::GasRiemann;

constexpr std::array<Index, 4> sizes{100, 200, 400, 800};
using Errors = std::array<double, 4>;

template <class R, class F>
void expect_errors(const GasProblem& problem, const R& reconstruction, const F& flux, const Errors& table) {
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    EXPECT_NEAR(test::density_error(problem, sizes[k], reconstruction, flux), table[k], 0.03 * table[k])
        << sizes[k];
  }
}

const PiecewiseLinear mc{Minmod{2}};
const PiecewiseLinear minmod{Minmod{1}};
const InPrimitives primitive_mc{PiecewiseLinear{Minmod{2}}, Euler<1>{}};

TEST(GasRiemann, HasTheStarStatesOfTheTable) {  // eight digits; the exact ones of this file
  const GasRiemann sod{test::sod.left, test::sod.right};
  EXPECT_NEAR(sod.star_pressure(), 0.30313018, 0.5e-8);
  EXPECT_NEAR(sod.star_velocity(), 0.92745262, 0.5e-8);
  EXPECT_NEAR(sod.star_density_left(), 0.42631943, 0.5e-8);
  EXPECT_NEAR(sod.star_density_right(), 0.26557371, 0.5e-8);
  const GasRiemann fans{test::fans_123.left, test::fans_123.right};
  EXPECT_NEAR(fans.star_pressure(), 0.0018938734, 0.5e-10);
  EXPECT_NEAR(fans.star_velocity(), 0, 1e-15);
  EXPECT_NEAR(fans.star_density_left(), 0.021852118, 0.5e-9);
  const GasRiemann collision{test::collision.left, test::collision.right};
  EXPECT_NEAR(collision.star_pressure(), 1691.647, 0.5e-3);
  EXPECT_NEAR(collision.star_velocity(), 8.6897744, 0.5e-7);
  EXPECT_NEAR(collision.star_density_left(), 14.28235, 0.5e-5);
  EXPECT_NEAR(collision.star_density_right(), 31.042602, 0.5e-6);
}

TEST(Sod, HasTheErrorsOfTheTable) {
  expect_errors(test::sod, minmod, KurganovTadmor{}, {9.724e-3, 5.539e-3, 3.047e-3, 1.684e-3});
  expect_errors(test::sod, mc, KurganovTadmor{}, {6.918e-3, 3.896e-3, 1.987e-3, 9.986e-4});
  expect_errors(test::sod, primitive_mc, KurganovNoellePetrova{}, {4.423e-3, 2.592e-3, 1.352e-3, 7.013e-4});
}

TEST(Collision, HasTheErrorsOfTheTable) {
  expect_errors(test::collision, mc, KurganovTadmor{}, {3.962e-1, 2.250e-1, 1.418e-1, 9.664e-2});
  expect_errors(test::collision, primitive_mc, KurganovNoellePetrova{},
                {3.995e-1, 2.440e-1, 1.574e-1, 1.102e-1});
}

TEST(Fans123, HasTheErrorsOfTheTable) {
  expect_errors(test::fans_123, primitive_mc, KurganovNoellePetrova{},
                {5.664e-3, 3.316e-3, 1.676e-3, 9.861e-4});
}

/// L1 error with nothing chosen but the ends and, as the tables have it, the CFL number.
double usual_error(const GasProblem& problem, Index n) {
  auto u = test::conserved_line(problem, n);
  auto options = test::open_ends();
  options.cfl = 0.4;
  Solver solver{Cartesian<1>{test::line(n, -0.5, 0.5, false)}, Euler<1>{}, options};
  solver.advance(u, problem.time);
  return test::density_error(u, problem);
}

// The row of the same flux, variables and limiter, 3 %: scaling of slopes changes it by less.
TEST(UsualSettings, HaveTheErrorsOfTheTable) {
  constexpr Errors table{4.9876e-3, 2.9183e-3, 1.5321e-3, 7.9592e-4};
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    EXPECT_NEAR(usual_error(test::sod, sizes[k]), table[k], 0.03 * table[k]) << sizes[k];
  }
}

// A contact is the slowest to converge: a scheme of order p smears it over n^(1/(p+1)) cells, so that the
// order is p/(p+1) = 2/3 (Banks, Aslam & Rider, 2008). Shocks have order 1, fans more.
TEST(UsualSettings, ConvergeForEachRiemannProblem) {
  for (const GasProblem& problem : {test::sod, test::fans_123, test::collision}) {
    EXPECT_GE(std::log2(usual_error(problem, 100) / usual_error(problem, 800)) / 3, 2.0 / 3);
  }
}

}  // namespace
}  // namespace scree::transport
