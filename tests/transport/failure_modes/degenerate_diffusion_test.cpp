// Failure mode 10: a diffusivity averaged between two cells moves a degenerate front badly, or not at all.

#include "../lines.hpp"

#include <scree/transport/components.hpp>
#include <scree/transport/reconstructions.hpp>
#include <scree/transport/solver.hpp>

#include <gtest/gtest.h>

namespace scree::transport {
namespace {

constexpr double half_width = 6;

/// u_t = (u^3)_xx from a point of mass.
double barenblatt(double x, double time) {
  const double s = x * x / std::sqrt(time) / 12;
  return s < 1 ? std::pow(time, -0.25) * std::sqrt(1 - s) : 0.0;
}

std::vector<double> averages(const Lattice<1>& lattice, double time) {
  return test::averages(lattice, [&](double x) {  // of sqrt(1 - (x/front)^2)
    const double front = std::sqrt(12 * std::sqrt(time));
    const double s = std::clamp(x / front, -1.0, 1.0);
    return barenblatt(0, time) * front * (s * std::sqrt(1 - s * s) + std::asin(s)) / 2;
  });
}

struct Result {
  double l1;
  double front;  ///< upper end of the last cell that holds a thousandth [m]
};

Result measure(const Lattice<1>& lattice, const std::vector<double>& u) {
  double front = 0;
  for (Index i = 0; i < lattice.count[0]; ++i) {
    if (u[static_cast<std::size_t>(i)] > 1e-3) front = lattice.position({i})[0] + lattice.spacing[0] / 2;
  }
  return {test::l1(u, averages(lattice, 2), lattice.spacing[0]), front};
}

/// Forward Euler from t = 1 to 2 with a diffusivity per face, of both sides' 3 u^2.
template <class Mean>
Result averaged(Index n, Mean&& mean) {
  const Lattice<1> lattice = test::line(n, -half_width, half_width);
  const double dx = lattice.spacing[0];
  auto u = averages(lattice, 1);
  const auto num_steps = static_cast<int>(std::ceil(1 / (0.4 * dx * dx / 3)));  // 3 u^2 <= 3
  std::vector<double> flux(u.size() + 1, 0.0);
  for (int step = 0; step < num_steps; ++step) {
    for (std::size_t i = 1; i < u.size(); ++i) {
      flux[i] = -mean(3 * u[i - 1] * u[i - 1], 3 * u[i] * u[i]) * (u[i] - u[i - 1]) / dx;
    }
    for (std::size_t i = 0; i < u.size(); ++i) u[i] -= (flux[i + 1] - flux[i]) / (num_steps * dx);
  }
  return measure(lattice, u);
}

/// No flux but that of the potential K(u) = u^3.
struct PorousMedium {
  static constexpr int num_components = 1;
  using State = std::array<double, 1>;

  State flux(const State& /*u*/, const Vector<1>& /*normal*/) const noexcept { return {0}; }
  double max_speed(const State&, const State&, const Vector<1>&) const noexcept { return 0; }
  State potential(const State& u) const noexcept { return {u[0] * u[0] * u[0]}; }
  double max_diffusivity(const State& left, const State& right) const noexcept {
    return 3 * larger(left[0] * left[0], right[0] * right[0]);
  }
};

constexpr Index n = 480;
constexpr double dx = 2 * half_width / n;
const double exact_front = std::sqrt(12 * std::sqrt(2.0));  // 4.1195

double harmonic(double a, double b) {
  return a + b > 0 ? 2 * a * b / (a + b) : 0.0;
}

TEST(DegenerateDiffusion, IsFrozenByTheHarmonicMean) {  // no face beside an empty cell is ever open
  const Result coarse = averaged(n / 2, harmonic);
  const Result fine = averaged(n, harmonic);
  const double first_front = std::sqrt(12.0);
  EXPECT_NEAR(fine.front, first_front, dx);  // it is where it was
  EXPECT_NEAR(fine.l1, 0.79, 0.03 * 0.79);   // table of another code
  EXPECT_GE(fine.l1, coarse.l1);             // and is no better on a finer grid
}

TEST(DegenerateDiffusion, IsRightByDifferencesOfThePotential) {
  const Lattice<1> lattice = test::line(n, -half_width, half_width, false);
  auto u = averages(lattice, 1);
  Solver{Cartesian<1>{lattice}, PorousMedium{}, PiecewiseConstant{}}.advance(u, 1);
  const Result by_potential = measure(lattice, u);
  const Result arithmetic = averaged(n, [](double a, double b) { return (a + b) / 2; });

  EXPECT_NEAR(by_potential.front, exact_front, dx);
  EXPECT_NEAR(arithmetic.front, exact_front, 2 * dx);  // a cell too far
  EXPECT_LE(by_potential.l1, 2e-4);                    // table: 1.74e-4, and 1.17e-3
  EXPECT_GE(arithmetic.l1, 5 * by_potential.l1);
  for (const double value : u) EXPECT_GE(value, 0);
}

}  // namespace
}  // namespace scree::transport
