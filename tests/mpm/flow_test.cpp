#include "bodies.hpp"
#include "schemes.hpp"

#include <scree/mpm/geostatic.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace scree::mpm {
namespace {

using std::numbers::pi;

constexpr Threads one_thread{1};

/// A layer of viscous fluid on a rough base that begins to flow under gravity along it.
struct StartUp {
  static constexpr double height = 1;       // [m]
  static constexpr double density = 1000;   // [kg/m^3]
  static constexpr double viscosity = 100;  // [Pa s]
  static constexpr double gravity = 3;      // along the base [m/s^2]
  static constexpr double time = 2.5;       // [s], a quarter of height^2/(kinematic viscosity)
  static constexpr double surface_speed = density * gravity * height * height / (2 * viscosity);  // at last

  /// The series solution of the Newtonian start-up from rest.
  static double velocity(double y, double t, double mu = viscosity) {
    double u = density * gravity / mu * (height * y - y * y / 2);
    for (int m = 0; m < 200; ++m) {
      const double k = (m + 0.5) * pi / height;
      const double weight = 2 * gravity * density / (mu * height * k * k * k);
      u -= weight * std::sin(k * y) * std::exp(-mu * k * k * t / density);
    }
    return u;
  }

  /// Mean error of the points' velocities after `time`, over the surface speed of the steady flow [-].
  static double error(Index num_cells, const AnyShape& shape, const AnyTransfer& rule) {
    const double spacing = height / static_cast<double>(num_cells);
    const auto grid = cube<1>(num_cells, spacing, false);
    auto particles = filled<1, 2>(grid, 3, density);
    auto stages = stages_of<1, 2>(particles, shape, rule, {1e5, density, viscosity});
    stages.boundaries.push_back(make_wall<1>(NoSlip{}, 0, Side::low));
    stages.gravity = {0, gravity};
    auto state = start(std::move(particles), grid, stages, one_thread);
    const auto num_steps = 2 * num_cells * num_cells;  // a quarter of the viscous limit
    const double dt = time / static_cast<double>(num_steps);
    for (Index n = 0; n < num_steps; ++n) step(state, stages, dt, one_thread);
    double sum = 0;
    double count = 0;
    for (Index p = 0; p < state.particles.size(); ++p) {
      if (!(state.particles.mass.component(0)[p] > 0)) continue;
      sum += std::abs(state.particles.velocity.component(1)[p] -
                      velocity(state.particles.position.component(0)[p], time));
      ++count;
    }
    return sum / count / surface_speed;
  }
};

TEST(ViscousStartUp, ConvergesWithSecondOrderToTheSeries) {
  for (const AnyShape& shape : every_shape_for(3)) {
    for (const AnyTransfer& rule : every<AnyTransfer>()) {
      std::array<double, 3> errors{};
      for (std::size_t i = 0; i < 3; ++i) errors[i] = StartUp::error(10 << i, shape, rule);

      // Error C h^2 (1 + c h): of the observed order the last grids leave no more than a tenth.
      for (std::size_t i = 1; i < 3; ++i) EXPECT_GT(std::log2(errors[i - 1] / errors[i]), 1.9);
      EXPECT_LT(errors[2], 1e-3);
    }
  }
}

TEST(ViscousStartUp, DoesNotConvergeUnderParticleInCell) {  // Eq. (M9): it adds a viscosity ~ h^2/dt
  // A point's way to the nodes and back spreads its velocity with the variance 2 xi (1 - xi) h^2, in the mean
  // 19/54 h^2 for xi = 1/6, 1/2, 5/6: a diffusivity of 19/108 h^2/dt. With dt = 5/4 h^2 it is the same on all
  // meshes, and what the flow converges to is that of a fluid as viscous.
  constexpr double added = 19.0 / 108 / 1.25 * StartUp::density;  // [Pa s]
  constexpr int num_places = 200;
  double expected = 0;
  for (int i = 0; i < num_places; ++i) {
    const double y = (i + 0.5) / num_places * StartUp::height;
    expected +=
        StartUp::velocity(y, StartUp::time) - StartUp::velocity(y, StartUp::time, StartUp::viscosity + added);
  }
  expected /= num_places * StartUp::surface_speed;

  for (const Index num_cells : {10, 20}) {
    const double of_the_mesh = StartUp::error(num_cells, Linear{}, PicFlip{1});
    EXPECT_NEAR(StartUp::error(num_cells, Linear{}, PicFlip{0}), expected, of_the_mesh);  // 0.097
  }
}

/// A column of 20 cells that rests under its own weight.
struct Rest {
  double speed = 0;  ///< largest, over that of sound [-]
  /// Largest |p - rho g z| of the means of cells, z the depth of their points, over rho g H [-].
  double pressure_error = 0;
};
[[nodiscard]] Rest rest_after(int num_steps, double compression) {
  constexpr double height = 1;
  constexpr Index num_cells = 20;
  constexpr double density = 1000;
  constexpr double gravity = 9.81;
  const Fluid fluid{
      .bulk_modulus = density * gravity * height / compression, .reference_density = density, .viscosity = 0};
  const auto grid = cube<1>(num_cells, height / num_cells, false);
  auto particles = filled<1>(grid, 3, density);
  auto stages = stages_of<1, 1>(particles, Linear{}, Apic{}, fluid);
  stages.boundaries.push_back(make_wall<1>(NoSlip{}, 0, Side::low));
  stages.gravity = {-gravity};
  set_geostatic(particles, *stages.stress, 0, height, gravity);
  auto state = start(std::move(particles), grid, stages, one_thread);
  const double dt = stable_time_step(grid, state.rates, {}).dt;
  for (int n = 0; n < num_steps; ++n) step(state, stages, dt, one_thread);

  std::array<double, num_cells> sums{};
  for (Index p = 0; p < state.particles.size(); ++p) {
    if (!(state.particles.mass.component(0)[p] > 0)) continue;
    const double place = state.particles.position.component(0)[p];
    sums[static_cast<std::size_t>(place / height * num_cells)] +=
        (-state.particles.stress.component(0)[p] / (density * gravity) - (height - place)) / (3 * height);
  }
  double worst = 0;
  for (const double sum : sums) worst = std::max(worst, std::abs(sum));
  return {largest(state.particles.velocity) / state.rates.wave_speed, worst};
}

TEST(HydrostaticColumn, StaysAtRestToRoundOffAndKeepsItsPressure) {
  constexpr int num_steps = 10000;
  constexpr double compression = 1e-5;  // rho g H/K

  const Rest rest = rest_after(num_steps, compression);

  // Each step rounds the density twice, which is a pressure of K round_off, and that a velocity of c
  // round_off. The weight of a cell and the pressures about it are sums over three points: they differ by the
  // square of the compression over a cell.
  const double per_cell = compression / 20;
  EXPECT_LE(rest.speed, 2 * num_steps * round_off + per_cell * per_cell);
  // Of every cell: densities grow downwards by the compression, and weight by half of it in the mean.
  EXPECT_LE(rest.pressure_error, compression / 2 + 2 * num_steps * round_off / compression);
}

/// A standing wave of sound, 32 cells long, with one point in the middle of each.
struct StandingWave {
  static constexpr Index num_cells = 32;
  static constexpr double spacing = 1.0 / num_cells;
  static constexpr double wave_number = 2 * pi;
  static constexpr double mach = 1e-8;  // amplitude over the speed of sound
  static constexpr Fluid fluid{.bulk_modulus = 1e5, .reference_density = 1000, .viscosity = 0};
  static constexpr double wave_speed = 10;

  /// Amplitude of the points' velocity after `num_steps`, over the initial one.
  static double amplitude(int num_steps, double dt) {
    const auto grid = cube<1>(num_cells, spacing, true);
    auto particles = filled<1>(grid, 1);
    const double half = wave_number * spacing / 2;
    for (Index p = 0; p < particles.size(); ++p) {
      const double x = particles.position.component(0)[p];
      particles.velocity.component(0)[p] = mach * wave_speed * std::cos(half) * std::sin(wave_number * x);
      particles.velocity_gradient.component(0)[p] =
          mach * wave_speed * 2 / spacing * std::sin(half) * std::cos(wave_number * x);
    }
    const auto stages = stages_of<1, 1>(particles, Linear{}, Apic{}, fluid);
    auto state = start(std::move(particles), grid, stages, one_thread);
    for (int n = 0; n < num_steps; ++n) step(state, stages, dt, one_thread);
    double sum = 0;
    double norm = 0;
    for (Index p = 0; p < state.particles.size(); ++p) {
      if (!(state.particles.mass.component(0)[p] > 0)) continue;
      const double mode = std::sin(wave_number * state.particles.position.component(0)[p]);
      sum += mode * state.particles.velocity.component(0)[p];
      norm += mode * mode;
    }
    return sum / norm / (mach * wave_speed * std::cos(half));
  }
};

TEST(StandingWave, RunsAtTheSpeedOfSoundOfTheMesh) {  // Eq. (M17)
  constexpr int num_steps = 100;
  constexpr double period = 1 / StandingWave::wave_speed;
  constexpr double dt = period / num_steps;

  const double amplitude = StandingWave::amplitude(num_steps, dt);

  // sin(omega dt/2) = (c dt/h) sin(k h/2), stress half a step behind velocity.
  const double half = StandingWave::wave_number * StandingWave::spacing / 2;
  const double turn = 2 * std::asin(StandingWave::wave_speed * dt / StandingWave::spacing * std::sin(half));
  const double expected = std::cos((num_steps - 0.5) * turn) / std::cos(turn / 2);
  // Points move by mach/(k h) of a cell, in each step; densities are rounded against changes of mach.
  const double tolerance = num_steps * (StandingWave::mach / (2 * half) + 4 * round_off / StandingWave::mach);
  EXPECT_NEAR(amplitude, expected, tolerance);
  // And that is the speed of sound up to (k h)^2/24 and (omega dt)^2/24.
  EXPECT_NEAR(turn / (2 * pi / num_steps), 1, (2 * half) * (2 * half) / 24);
}

}  // namespace
}  // namespace scree::mpm
