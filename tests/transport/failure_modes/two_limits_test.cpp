// Failure mode 11: the smaller of the limits of convection and of diffusion is no limit of both. It breaks
// only where they meet, so that a test on one grid does not see it.

#include "../lines.hpp"

#include <scree/transport/components.hpp>
#include <scree/transport/integrators.hpp>
#include <scree/transport/limiters.hpp>
#include <scree/transport/reconstructions.hpp>
#include <scree/transport/solver.hpp>

#include <gtest/gtest.h>

#include <utility>

namespace scree::transport {
namespace {

constexpr double viscosity = 0.05;
constexpr double speed = 2;

struct ViscousBurgers {
  static constexpr int num_components = 1;
  using State = std::array<double, 1>;

  State flux(const State& u, const Vector<1>& normal) const noexcept { return {normal[0] * u[0] * u[0] / 2}; }
  double max_speed(const State& left, const State& right, const Vector<1>& /*normal*/) const noexcept {
    return larger(std::abs(left[0]), std::abs(right[0]));
  }
  State potential(const State& u) const noexcept { return {viscosity * u[0]}; }
  double max_diffusivity(const State&, const State&) const noexcept { return viscosity; }
};

/// The wave 1 - tanh((x - t)/(2 nu)) on [-2, 3].
std::vector<double> wave(const Lattice<1>& lattice, double time) {
  return test::averages(lattice, [=](double x) {
    const double s = std::abs(x - time) / (2 * viscosity);  // log cosh without overflow
    return x - 2 * viscosity * (s + std::log1p(std::exp(-2 * s)));
  });
}

/// Error at T = 1 with steps of a given length, which no one checks; infinite if it blew up.
double error(Index n, double longest) {
  using Rates = SemiDiscrete<Cartesian<1>, ViscousBurgers, PiecewiseLinear<Minmod>, KurganovTadmor>;
  const Lattice<1> lattice = test::line(n, -2, 3, false);
  Rates rates{
      {lattice, ViscousBurgers{}, PiecewiseLinear{Minmod{2}}, {}, {{{Prescribed<1>{{2.0}}, Outflow{}}}}},
      0.5,
      {}};
  Fields<1> now{n};
  Fields<1> stage{n};
  Fields<1> rate{n};
  auto u = wave(lattice, 0);
  now.gather(u, {});
  const double dt = 1 / std::ceil(1 / longest);
  for (double time = 0; time < 1 - dt / 2; time += dt) {
    stage = now;
    for (const double kept : SspRk2::kept) {
      try {
        rates(stage, rate, time);
      } catch (const RunError&) {
        return std::numeric_limits<double>::infinity();
      }
      for (std::size_t i = 0; i < u.size(); ++i) {
        stage.all()[i] = kept * now.all()[i] + (1 - kept) * (stage.all()[i] + dt * rate.all()[i]);
      }
    }
    now = stage;
  }
  now.scatter(u, {}, [](Index) { return true; });
  return test::l1(u, wave(lattice, 1), lattice.spacing[0]);
}

double smaller_limit(Index n) {
  const double dx = 5.0 / static_cast<double>(n);
  return std::min(0.4 * dx / speed, 0.4 * dx * dx / viscosity);
}

double common_limit(Index n) {
  const double dx = 5.0 / static_cast<double>(n);
  return 0.5 / (speed / dx + 2 * viscosity / (dx * dx));
}

TEST(TwoLimits, AreNotKeptByTheSmallerOfBoth) {  // they meet at dx = 0.025, N = 200
  EXPECT_LE(error(50, smaller_limit(50)), 0.1);  // convection is far the stricter one: all seems well
  double worst = 0;
  for (const Index n : {100, 200, 300, 400}) worst = std::max(worst, error(n, smaller_limit(n)));
  EXPECT_GE(worst, 1);
}

// Eq. (T9), on every grid of the scan; a table of another code with the same steps: 3 %.
TEST(TwoLimits, AreKeptByTheirSum) {
  for (const auto& [n, l1] :
       {std::pair<Index, double>{50, 1.831e-2}, {100, 3.825e-3}, {200, 1.187e-3}, {400, 3.324e-4}}) {
    EXPECT_NEAR(error(n, common_limit(n)), l1, 0.03 * l1) << n;
  }
}

}  // namespace
}  // namespace scree::transport
