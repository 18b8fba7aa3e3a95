#include "lines.hpp"

#include <scree/transport/components.hpp>
#include <scree/transport/integrators.hpp>
#include <scree/transport/limiters.hpp>
#include <scree/transport/reconstructions.hpp>
#include <scree/transport/solver.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace scree::transport {
namespace {

/// Burgers' equation with viscosity: K(u) = nu u.
struct ViscousBurgers {
  static constexpr int num_components = 1;
  using State = std::array<double, 1>;
  double viscosity;

  State flux(const State& u, const Vector<1>& normal) const noexcept { return {normal[0] * u[0] * u[0] / 2}; }
  double max_speed(const State& left, const State& right, const Vector<1>& /*normal*/) const noexcept {
    return larger(std::abs(left[0]), std::abs(right[0]));
  }
  State potential(const State& u) const noexcept { return {viscosity * u[0]}; }
  double max_diffusivity(const State& /*left*/, const State& /*right*/) const noexcept { return viscosity; }
};

/// No flux but that of the potential K(u) = u^3, which has no diffusivity where there is nothing.
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

/// Error of the wave 1 - tanh((x - t)/(2 nu)), nu = 0.05, on [-2, 4] at T = 1.
double wave_error(Index n) {
  constexpr double viscosity = 0.05;
  const Lattice<1> lattice = test::line(n, -2, 4, false);
  const auto wave = [&](double time) {
    return test::averages(lattice, [=](double x) {
      const double s = std::abs(x - time) / (2 * viscosity);  // log cosh without overflow
      return x - 2 * viscosity * (s + std::log1p(std::exp(-2 * s)));
    });
  };
  auto u = wave(0);
  Solver solver{Cartesian<1>{lattice},
                ViscousBurgers{viscosity},
                PiecewiseLinear{Minmod{2}},
                SspRk2{},
                {.cfl = 0.5, .boundaries = {{{Prescribed<1>{{2.0}}, Outflow{}}}}}};
  solver.advance(u, 1);
  return test::l1(u, wave(1), lattice.spacing[0]);
}

TEST(Diffusion, IsSecondOrderAndStableOnEveryGrid) {  // one limit for both: a scan finds where two would fail
  double coarser = wave_error(150);
  for (const Index n : {300, 600, 1200}) {  // cells of 0.02 and less resolve the wave, 0.1 wide
    const double finer = wave_error(n);
    EXPECT_GE(std::log2(coarser / finer), 1.5) << n;
    coarser = finer;
  }
  EXPECT_LE(coarser, 2e-3);
}

TEST(Diffusion, MovesADegenerateFront) {  // Barenblatt, u_t = (u^3)_xx, t = 1 to 2
  const Lattice<1> lattice = test::line(480, -6, 6, false);
  const auto barenblatt = [](double x, double time) {
    const double s = x * x / std::sqrt(time) / 12;
    return s < 1 ? std::pow(time, -0.25) * std::sqrt(1 - s) : 0.0;
  };
  std::vector<double> u;
  std::vector<double> exact;
  for (Index i = 0; i < 480; ++i) {
    const double x = lattice.position({i})[0];
    u.push_back(barenblatt(x, 1));
    exact.push_back(barenblatt(x, 2));
  }
  Solver solver{Cartesian<1>{lattice}, PorousMedium{}, PiecewiseConstant{}};

  solver.advance(u, 1);

  // The front is at sqrt(12 sqrt 2) = 4.1195; cells of 0.025; the profile rises like a square root there.
  double front = 0;
  for (Index i = 0; i < 480; ++i) {
    if (u[static_cast<std::size_t>(i)] > 1e-3) front = lattice.position({i})[0];
  }
  EXPECT_NEAR(front, 4.1195, 0.03);
  EXPECT_LE(test::l1(u, exact, lattice.spacing[0]), 1e-2);
  for (const double value : u) EXPECT_GE(value, 0);
}

}  // namespace
}  // namespace scree::transport
