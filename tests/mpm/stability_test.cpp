#include "bodies.hpp"
#include "schemes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace scree::mpm {
namespace {

// The shortest wave of a periodic mesh, up at one node and down at the next, one point in the middle of each
// cell: hat functions make finite differences of it, and the limits have closed forms.

constexpr Threads one_thread{1};
constexpr Index num_cells = 8;
constexpr double spacing = 0.125;
constexpr TimeStepOptions whole_limits{.acoustic = 1, .advective = 1, .viscous = 1, .maximum = 0};

/// +1 in cells of even number, -1 in odd ones.
double sign_at(double x) {
  return std::fmod(std::floor(x / spacing), 2) == 0 ? 1 : -1;
}

/// Growth of the wave in component `component` of the velocity over `num_steps`, each `share` of the limit.
template <int V>
double growth(const Fluid& law, int component, double share, int num_steps) {
  constexpr double amplitude = 1e-9;  // [m/s], small: the wave stays linear as it grows
  const auto grid = cube<1>(num_cells, spacing, true);
  auto particles = filled<1, V>(grid, 1);
  double* gradient = particles.velocity_gradient.component(component);
  for (Index p = 0; p < particles.size(); ++p) {
    gradient[p] = 2 * amplitude / spacing * sign_at(particles.position.component(0)[p]);
  }
  const auto stages = stages_of<1, V>(particles, Linear{}, Apic{}, law);
  auto state = start(std::move(particles), grid, stages, one_thread);
  const double dt = share * stable_time_step(grid, state.rates, whole_limits).dt;
  for (int n = 0; n < num_steps; ++n) step(state, stages, dt, one_thread);
  return std::abs(state.particles.velocity_gradient.component(component)[0]) / (2 * amplitude / spacing);
}

constexpr Fluid syrup{.bulk_modulus = 0, .reference_density = 1000, .viscosity = 100};
constexpr Fluid air{.bulk_modulus = 1e5, .reference_density = 1000, .viscosity = 0};

/// What a step may add to a wave of sound, relative to it: its amplitude is 1e-10 of the speed of sound, the
/// density on which it rides is rounded some five times.
constexpr double per_step = 1e-10 + 5 * round_off / 1e-10;

TEST(ExplicitViscosity, BlowsUpJustAboveItsLimit) {  // Eq. (M19): 1 - 4 nu dt/h^2 per step
  constexpr int num_steps = 400;
  for (const double share : {0.99, 1.01}) {
    const double expected = std::pow(2 * share - 1, num_steps);

    const double actual = growth<2>(syrup, 1, share, num_steps);

    EXPECT_NEAR(actual, expected, rounding_of(1, 2, num_steps) * (1 + expected));
  }
}

TEST(ExplicitSound, StaysBoundedJustBelowItsLimit) {  // Eq. (M17)
  const double share = 0.99;                          // cos((n - 1/2) w)/cos(w/2) with sin(w/2) = share
  const double bound = 1 / std::sqrt(1 - share * share);

  for (const int num_steps : {10, 100, 1000}) {
    EXPECT_LE(growth<1>(air, 0, share, num_steps), bound * (1 + num_steps * per_step));
  }
}

TEST(ExplicitSound, BlowsUpJustAboveItsLimit) {  // Eq. (M17)
  constexpr int num_steps = 30;
  const double share = 1.01;
  const double eta = std::acosh(2 * share * share - 1);

  const double actual = growth<1>(air, 0, share, num_steps);

  const double expected = std::sinh((num_steps - 0.5) * eta) / std::sinh(eta / 2);  // 3300
  EXPECT_NEAR(actual, expected, num_steps * per_step * expected);
}

/// Growth of an up-and-down of density under FLIP, which reaches no point's velocity.
double flip_growth(double courant, int num_steps) {
  constexpr double disturbance = 1e-9;  // of the density
  const auto grid = cube<1>(num_cells, spacing, true);
  auto particles = filled<1>(grid, 1);
  for (Index p = 0; p < particles.size(); ++p) {
    particles.density.component(0)[p] *= 1 + disturbance * sign_at(particles.position.component(0)[p]);
  }
  const auto stages = stages_of<1, 1>(particles, Linear{}, PicFlip{1}, air);
  auto state = start(std::move(particles), grid, stages, one_thread);
  const double dt = courant * stable_time_step(grid, state.rates, whole_limits).dt;
  for (int n = 0; n < num_steps; ++n) step(state, stages, dt, one_thread);
  return std::abs(state.particles.density.component(0)[0] / 1000 - 1) / disturbance;
}

TEST(FlipOnHatFunctions, IsUnstableFromACourantNumberOfOneOverRootTwo) {  // Eq. (M17): 1 - 4 C^2 per step
  constexpr int num_steps = 200;
  for (const double courant : {0.70, 0.714}) {
    const double expected = std::pow(std::abs(1 - 4 * courant * courant), num_steps);

    const double actual = flip_growth(courant, num_steps);

    // Densities are rounded some five times per step, to round_off/1e-9 of the disturbance.
    EXPECT_NEAR(actual, expected,
                5 * num_steps * round_off / 1e-9 * (1 + expected) + 1e-9 * num_steps * expected);
  }
}

/// Largest velocity of points in the middle of cells after some steps from a wave of four cells, over the
/// first, under FLIP with hat functions.
double wave_growth(double courant, Order order, int num_steps) {
  const auto grid = cube<1>(num_cells, spacing, true);
  auto particles = filled<1>(grid, 1);
  constexpr double amplitude = 1e-9;  // over the speed of sound
  const double c = std::sqrt(air.bulk_modulus / 1000);
  for (Index p = 0; p < particles.size(); ++p) {
    particles.velocity.component(0)[p] =
        amplitude * c * std::cos(std::numbers::pi / 2 * particles.position.component(0)[p] / spacing);
  }
  const double first = largest(particles.velocity);
  auto stages = stages_of<1, 1>(particles, Linear{}, PicFlip{1}, air);
  stages.order = order;
  auto state = start(std::move(particles), grid, stages, one_thread);
  for (int n = 0; n < num_steps; ++n) step(state, stages, courant * spacing / c, one_thread);
  return largest(state.particles.velocity) / first;
}

TEST(FlipOnHatFunctions, IsStableToACourantNumberOfTwoIfStressComesFirst) {  // Eq. (M134)
  // Strain by mapped velocities is blind to the shortest wave. That of four cells is the first to go:
  // sin(omega dt/2) = (C/2) sin(k h), sin^2(k h/2) of the nodes times the cos^2(k h/2) that points feel.
  for (const Order order : {Order::usf, Order::musl}) {
    const double share = 0.99;  // cos((n + 1/2) w)/cos(w/2) with sin(w/2) = share
    EXPECT_LE(wave_growth(2 * share, order, 400), (1 + 400 * 1e-6) / std::sqrt(1 - share * share));
    constexpr int num_steps = 50;
    const double eta = std::acosh(2 * 1.01 * 1.01 - 1);
    EXPECT_GT(wave_growth(2 * 1.01, order, num_steps), std::sinh((num_steps - 1) * eta) / std::sinh(eta));
  }
}

template <class Dimension>
class EveryScheme : public ::testing::Test {};
TYPED_TEST_SUITE(EveryScheme, Dimensions);

TYPED_TEST(EveryScheme, StaysBoundedAtTheDefaultSharesOfTheLimits) {
  constexpr int D = TypeParam::value;
  for (const Scheme& scheme : every_scheme()) {
    SCOPED_TRACE(scheme.name());
    const Fluid mud{.bulk_modulus = 1e5, .reference_density = 1000, .viscosity = 100};
    const auto grid = cube<D>(6, spacing, true);
    auto particles = filled<D>(grid, 2);
    fill_at_random(particles.velocity, 1e-6);
    const auto stages = stages_of<D, D>(particles, scheme.shape, scheme.rule, mud);
    auto state = start(std::move(particles), grid, stages, one_thread);

    for (int n = 0; n < 300; ++n) step(state, stages, stable_time_step(grid, state.rates, {}).dt, one_thread);

    EXPECT_LE(largest(state.particles.velocity), 2e-6);
  }
}

}  // namespace
}  // namespace scree::mpm
