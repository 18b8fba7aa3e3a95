// Where schemes break, at the threshold that theory gives, and what the library does about it.

#include "lines.hpp"

#include <scree/transport/integrators.hpp>
#include <scree/transport/laws/advection.hpp>
#include <scree/transport/reconstructions.hpp>
#include <scree/transport/solver.hpp>

#include <gtest/gtest.h>

namespace scree::transport {
namespace {

using test::pi;

/// Minmod without its guard.
struct Steep {
  static constexpr std::string_view name = "steep";
  static constexpr std::string_view summary = "theta beyond 2";
  double theta;
  double operator()(double backward, double forward) const noexcept {
    if (backward * forward <= 0) return 0;
    const double gentlest =
        std::min({theta * std::abs(backward), std::abs(backward + forward) / 2, theta * std::abs(forward)});
    return std::copysign(gentlest, forward);
  }
  double sharpness() const noexcept { return theta; }
};

double overshoot(double theta) {
  const Lattice<1> lattice = test::line(100, 0, 1);
  std::vector<double> u(100, 0.0);
  std::fill(u.begin() + 25, u.begin() + 75, 1.0);
  Solver solver{Cartesian<1>{lattice},
                Advection<1>{Vector<1>{1.0}},
                PiecewiseLinear{Steep{theta}},
                SspRk2{},
                {.cfl = 0.25}};
  solver.advance(u, 1);
  return *std::max_element(u.begin(), u.end()) - 1;
}

TEST(ThetaBeyondTwo, Overshoots) {           // table: 0, 1.68e-2, 3.31e-2 of the step, three digits
  EXPECT_LE(overshoot(2), 100 * round_off);  // a few hundred steps that each keep the bound
  EXPECT_NEAR(overshoot(2.2), 1.68e-2, 0.005e-2);
  EXPECT_NEAR(overshoot(2.5), 3.31e-2, 0.005e-2);
}

/// Largest slope of sin x after ten periods, 100 cells, CFL 0.4; exact 1.
template <class L>
double staircase(const L& limiter, Stages stages) {
  const Lattice<1> lattice = test::line(100, 0, 2 * pi);
  auto u = test::averages(lattice, [](double x) { return -std::cos(x); });
  Solver solver{
      Cartesian<1>{lattice}, Advection<1>{Vector<1>{1.0}}, PiecewiseLinear{limiter}, stages, {.cfl = 0.4}};
  solver.advance(u, 20 * pi);
  double steepest = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    steepest = std::max(steepest, std::abs(u[(i + 1) % u.size()] - u[i]) / lattice.spacing[0]);
  }
  return steepest;
}

TEST(Staircase, IsWhatForwardEulerMakesOfASine) {  // though it passes each test of bounds and variation
  EXPECT_NEAR(staircase(Minmod{1}, ForwardEuler{}), 13.4, 0.7);  // 5 %: the growth is exponential
  EXPECT_NEAR(staircase(Minmod{1.3}, ForwardEuler{}), 7.9, 0.4);
  EXPECT_NEAR(staircase(Minmod{2}, ForwardEuler{}), 6.0, 0.3);
}

TEST(Staircase, IsNotThereWithMoreStages) {
  for (const double theta : {1.0, 1.3, 2.0}) {
    EXPECT_LE(staircase(Minmod{theta}, SspRk2{}), 1.35) << theta;
    EXPECT_LE(staircase(Minmod{theta}, SspRk3{}), 1.35) << theta;
  }
  EXPECT_LE(staircase(VanLeer{}, SspRk2{}), 1.35);
  EXPECT_LE(staircase(VanAlbada{}, SspRk2{}), 1.35);
}

TEST(Staircase, StaysWithSuperbee) {
  EXPECT_NEAR(staircase(Superbee{}, SspRk2{}), 2.49, 0.13);
}

/// A cell of width alpha dx among cells of dx, stepped with dt = 0.4 dx, first order: stable while the
/// small cell's own number, dt/(alpha dx), is below 2.
double largest_beside_small_cell(double alpha) {
  std::vector<double> width(40, 1.0);
  width[20] = alpha;
  std::vector<double> u(40, 0.0);
  std::fill(u.begin() + 5, u.begin() + 15, 1.0);
  double largest = 0;
  for (int step = 0; step < 200; ++step) {
    const auto rate = [&](const std::vector<double>& v, std::size_t i) {
      return (v[(i + 39) % 40] - v[i]) / width[i];
    };
    std::vector<double> stage(40);
    for (std::size_t i = 0; i < 40; ++i) stage[i] = u[i] + 0.4 * rate(u, i);
    std::vector<double> next(40);
    for (std::size_t i = 0; i < 40; ++i) next[i] = 0.5 * u[i] + 0.5 * (stage[i] + 0.4 * rate(stage, i));
    u = next;
    for (const double value : u) largest = std::max(largest, std::abs(value));
  }
  return largest;
}

TEST(SmallCell, BlowsUpBelowAFifthOfTheOthers) {  // 0.4/2; slivers of mass do not
  EXPECT_LE(largest_beside_small_cell(0.21), 1 + 1e-12);
  EXPECT_GE(largest_beside_small_cell(0.15), 1e10);
}

}  // namespace
}  // namespace scree::transport
