#include "lines.hpp"

#include <scree/transport/fluxes.hpp>
#include <scree/transport/laws.hpp>
#include <scree/transport/reconstructions.hpp>
#include <scree/transport/solver.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace scree::transport {
namespace {

/// A ring of gas that spreads, 24 x 24 cells.
std::vector<double> ring(const Lattice<2>& lattice) {
  const Euler<2> gas;
  std::vector<double> u;
  for (Index site = 0; site < lattice.num_sites(); ++site) {
    const Vector<2> x = lattice.position(lattice.site(site)) - Vector<2>{0.5, 0.5};
    const double bump = std::exp(-40 * std::pow(x.norm() - 0.2, 2));
    const auto cell = gas.state(1 + bump, Vector<2>{0.3, -0.2}, 1 + 2 * bump);
    u.insert(u.end(), cell.begin(), cell.end());
  }
  return u;
}

/// A gas as a user would write it, gamma captured.
auto users_gas(double gamma) {
  using State = std::array<double, 4>;
  const auto pressure = [gamma](const State& u) {
    return (gamma - 1) * (u[3] - 0.5 * (u[1] * u[1] + u[2] * u[2]) / u[0]);
  };
  const auto fastest = [=](const State& u, const Vector<2>& normal) {
    const double speed = (u[1] * normal[0] + u[2] * normal[1]) / u[0];
    return std::abs(speed) + std::sqrt(gamma * pressure(u) / u[0]);
  };
  return make_law<4, 2>(
      [=](const State& u, const Vector<2>& normal) {
        const double p = pressure(u);
        const double speed = (u[1] * normal[0] + u[2] * normal[1]) / u[0];
        return State{u[0] * speed, u[1] * speed + p * normal[0], u[2] * speed + p * normal[1],
                     (u[3] + p) * speed};
      },
      [=](const State& left, const State& right, const Vector<2>& normal) {
        return larger(fastest(left, normal), fastest(right, normal));
      });
}

TEST(MakeLaw, IsTheBuiltInGas) {
  const Lattice<2> lattice = test::cube<2>(24);
  auto one = ring(lattice);
  auto other = one;

  Solver{Cartesian<2>{lattice}, Euler<2>{1.4}, PiecewiseLinear{Minmod{}}}.advance(one, 0.1);
  Solver{Cartesian<2>{lattice}, users_gas(1.4), PiecewiseLinear{Minmod{}}}.advance(other, 0.1);

  // The same operations, in another order of sums: some twenty steps of a hundred roundings of numbers below
  // 8, in a flow that is smooth.
  EXPECT_LE(test::linf(one, other), 20 * 100 * 8 * round_off);
}

TEST(MakeLaw, IsTheBuiltInLawToTheBit) {
  const Lattice<1> lattice = test::line(100, 0, 1);
  const auto law = make_law<1, 1>(
      [](double u, const Vector<1>& normal) { return normal[0] * (0.5 * u * u); },
      [](double left, double right, const Vector<1>&) { return larger(std::abs(left), std::abs(right)); });
  auto one = test::square_and_bump(100);
  auto other = one;

  Solver{Cartesian<1>{lattice}, Burgers{}, PiecewiseLinear{VanLeer{}}}.advance(one, 0.3);
  Solver{Cartesian<1>{lattice}, law, PiecewiseLinear{VanLeer{}}}.advance(other, 0.3);

  EXPECT_EQ(one, other);
}

TEST(MakeLaw, HasNothingToWarnOf) {
  EXPECT_TRUE((Solver<Cartesian<2>, decltype(users_gas(1.4)), PiecewiseConstant>::warnings().empty()));
}

TEST(WithSource, AddsWhatTheFunctionSays) {  // du/dt = -u at rest: exact to the order of SSPRK2
  const Lattice<1> lattice = test::line(10, 0, 1);
  const double rate = 2;  // captured
  const auto law =
      with_source(Advection<1>{Vector<1>{0.0}}, [=](const std::array<double, 1>& u, const Vector<1>&,
                                                    double) { return std::array<double, 1>{-rate * u[0]}; });
  std::vector<double> u(10, 1.0);
  Solver solver{Cartesian<1>{lattice}, law};
  constexpr int steps = 100;
  for (int step = 0; step < steps; ++step) solver.advance(u, 1.0 / steps);
  // One step of SSPRK2 multiplies by 1 - z + z^2/2, z = rate / steps.
  const double z = rate / steps;
  EXPECT_NEAR(u[4], std::pow(1 - z + z * z / 2, steps), 8 * steps * round_off);
}

TEST(WithSpeedRange, MakesTheCentralUpwindFluxUpwind) {
  const Vector<1> normal{1.0};
  const auto burgers = make_law<1, 1>(
      [](double u, const Vector<1>& n) { return n[0] * (0.5 * u * u); },
      [](double left, double right, const Vector<1>&) { return larger(std::abs(left), std::abs(right)); });
  const auto ranged = with_speed_range(burgers, [](const std::array<double, 1>& left,
                                                   const std::array<double, 1>& right, const Vector<1>& n) {
    return SpeedRange{std::min(n[0] * left[0], n[0] * right[0]), std::max(n[0] * left[0], n[0] * right[0])};
  });
  const KurganovNoellePetrova flux;
  EXPECT_DOUBLE_EQ(flux(ranged, {1.0}, {2.0}, normal).value[0], 0.5);
  EXPECT_GT(std::abs(flux(burgers, {1.0}, {2.0}, normal).value[0] - 0.5), 0.2);  // central: 5/4 - 1
}

/// f = u^2/2 with a step of height 0.05 at u = 0.53, 1e-3 wide: f' is 25 there and below 1 elsewhere.
double spiked(double u) {
  return 0.5 * u * u + 0.05 * std::tanh((u - 0.53) / 2e-3);
}

/// Error of the sampled speed of sin(3 u) between -1 and 0.9; exact 3, at u = 0.
double sampling_error(int num_samples) {
  const auto flux = [](double u, const Vector<1>& normal) { return normal[0] * std::sin(3 * u); };
  const SampledSpeed<1, decltype(flux)> speed{flux, {.num_samples = num_samples}};
  return std::abs(speed(-1, 0.9, Vector<1>{1.0}) - 3);
}

TEST(SampledSpeed,
     ConvergesWithTheNumberOfSamples) {          // Eq. (T21): the margin, f'' times a part, is the error
  EXPECT_LE(sampling_error(16), 27 * 1.9 / 16);  // |f'''| <= 27 times half a part, f'' <= 9 times a part
  const double order = std::log2(sampling_error(64) / sampling_error(256)) / 2;
  EXPECT_GE(order, 0.9);
}

TEST(SampledSpeed, BoundsAQuadraticFlux) {
  const auto law = make_law<1>([](double u, const Vector<1>& normal) { return normal[0] * 0.5 * u * u; });
  const Vector<1> normal{1.0};
  // Slopes of the parts: their mean u; the last is half a part from the end, the margin a whole one.
  EXPECT_NEAR(law.max_speed({-1.0}, {0.5}, normal), 1 + 0.5 * 1.5 / 16, 1e-14);
  EXPECT_NEAR(law.max_speed({0.7}, {0.7}, normal), 0.7, 0.6e-6);  // half the step, and its part
}

TEST(SampledSpeed, MissesASpikeBetweenTwoSamples) {  // its failure: 16 parts of 1/16, the step is 1/250 wide
  const auto flux = [](double u, const Vector<1>& normal) { return normal[0] * spiked(u); };
  const auto few = make_law<1>(flux);
  const auto many = make_law<1>(flux, {.num_samples = 4000});
  const Vector<1> normal{1.0};
  EXPECT_LE(few.max_speed({0.0}, {1.0}, normal), 5);  // 0.1 over one part is 1.6, the margin as much
  EXPECT_GE(many.max_speed({0.0}, {1.0}, normal), 25);
}

/// What has passed x = 0 at T = 1/2 from a jump 1 | 0, of f = sin^2(16 pi u)/(16 pi). A sixteenth part of the
/// jump has the same flux at both ends; the exact solution sends T max f = 1/(32 pi) through.
double passed(Index n, int num_samples) {
  const Lattice<1> lattice = test::line(n, -1, 1, false);
  std::vector<double> u(static_cast<std::size_t>(n), 0.0);
  std::fill(u.begin(), u.begin() + n / 2, 1.0);
  const auto law = make_law<1>(
      [](double w, const Vector<1>& normal) {
        const double sine = std::sin(16 * test::pi * w);
        return normal[0] * sine * sine / (16 * test::pi);
      },
      {.num_samples = num_samples});
  Solver solver{Cartesian<1>{lattice},
                law,
                PiecewiseConstant{},
                SspRk2{},
                {.cfl = 0.5, .boundaries = {{{Outflow{}, Outflow{}}}}}};
  solver.advance(u, 0.5);
  double sum = 0;
  for (auto value = u.begin() + n / 2; value != u.end(); ++value) sum += *value * lattice.spacing[0];
  return sum;
}

TEST(SampledSpeed, FreezesAJumpWhoseSamplesAllHaveTheSameFlux) {
  EXPECT_NEAR(passed(400, 16), 0, 1e-12);  // but for the rounding of f at the samples
}

TEST(SampledSpeed, LetsTheJumpGoWithMoreSamples) {  // at the order 1/2 that Kuznetsov proved, or better
  const auto excess = [](Index n) { return passed(n, 40) - 1 / (32 * test::pi); };
  EXPECT_GE(excess(100), 0);
  EXPECT_LE(std::abs(excess(400)), excess(100) / 2);
}

TEST(SampledSpeed, StaysWhereThereIsAFlux) {  // sqrt(u): nothing below 0
  const auto law = make_law<1>([](double u, const Vector<1>& normal) { return normal[0] * std::sqrt(u); },
                               {.smallest_step = 1e-2, .lowest = 0});
  EXPECT_TRUE(std::isfinite(law.max_speed({0.0}, {0.0}, Vector<1>{1.0})));
}

TEST(SampledSpeed, PassesOnANaN) {
  const auto law = make_law<1>([](double u, const Vector<1>& normal) { return normal[0] * u * u; });
  EXPECT_TRUE(std::isnan(law.max_speed({std::nan("")}, {0.5}, Vector<1>{1.0})));
  EXPECT_TRUE(std::isnan(law.max_speed({0.5}, {std::nan("")}, Vector<1>{1.0})));
}

TEST(SampledSpeed, SaysThatItIsNotProven) {
  const auto law = make_law<1>([](double u, const Vector<1>& normal) { return normal[0] * u * u; });
  const Solver solver{Cartesian<1>{test::line(10, 0, 1)}, law};
  EXPECT_EQ(solver.warnings(),
            std::vector<std::string_view>{"the wave speed is sampled from the flux: a spike between two "
                                          "samples is missed, and with it stability"});
  const Solver proven{Cartesian<1>{test::line(10, 0, 1)}, Burgers{}};
  EXPECT_TRUE(proven.warnings().empty());
}

TEST(SampledSpeed, RefusesWhatCannotBe) {
  const auto flux = [](double u, const Vector<1>& normal) { return normal[0] * u; };
  const auto message = [&](const Sampling& sampling) {
    return test::message_of<InputError>([&] { (void)make_law<1>(flux, sampling); });
  };
  EXPECT_EQ(message({.num_samples = 1}), "SampledSpeed: two samples are the fewest");
  EXPECT_EQ(message({.smallest_step = 0}), "SampledSpeed: the smallest step must be positive and finite");
  EXPECT_EQ(message({.lowest = 1, .highest = 1}),
            "SampledSpeed: the highest state must exceed the lowest by more than the smallest step");
}

}  // namespace
}  // namespace scree::transport
