// Layers down a slope under laws of the list, against their steady profiles in closed form.

#include <scree/mpm/critical_step.hpp>
#include <scree/mpm/geostatic.hpp>
#include <scree/mpm/seed.hpp>
#include <scree/mpm/step.hpp>
#include <scree/rheology/laws/elastic_herschel_bulkley.hpp>
#include <scree/rheology/laws/granular_elastoviscoplastic.hpp>
#include <scree/rheology/laws/newtonian.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>

namespace scree::app::testing {
namespace {

using Profile = std::function<double(double)>;  ///< height above the base [m] to velocity [m/s]

constexpr double gravity = 9.81;  // [m/s^2]

/// A layer on a rough base, a column across it, under gravity that is tilted.
struct Layer {
  double height;    ///< [m]
  double degrees;   ///< slope of the base
  Index num_cells;  ///< over the height
  double duration;  ///< [s]

  [[nodiscard]] double along() const { return gravity * std::sin(degrees * std::numbers::pi / 180); }
  [[nodiscard]] double across() const { return gravity * std::cos(degrees * std::numbers::pi / 180); }
};

/// Largest |v - exact| of the points over the exact surface speed, after the layer has run, at first with the
/// velocities of `begin`.
template <class Law>
double error_after(const Layer& layer, const Law& law, const Profile& begin, const Profile& exact) {
  const double spacing = layer.height / static_cast<double>(layer.num_cells);
  const CartesianGrid<1> grid{Vector<1>{0.0}, Vector<1>{spacing}, {layer.num_cells + 1}, {false}};
  auto particles = mpm::seed_box<1, 2>(grid, Vector<1>{0.0}, Vector<1>{layer.height}, {2}, law.density);
  for (const InputColumn& input : Law::inputs) {
    const std::size_t column =
        particles.add_column({std::string{input.name}, "", std::string{input.unit}}, 1);
    for (double& value : particles.column(column).values()) value = 1.65e-3;  // grain size [m]
  }
  mpm::Stages<1, 2> stages;
  stages.stress = std::make_unique<mpm::StressUpdateBy<1, 2, Law>>(law, particles);
  stages.transfer = mpm::make_transfer<1, 2>(mpm::Linear{}, mpm::Apic{});
  stages.boundaries.push_back(mpm::make_wall<1>(mpm::NoSlip{}, 0, mpm::Side::low));
  stages.gravity = {-layer.across(), layer.along()};
  mpm::set_geostatic(particles, *stages.stress, 0, layer.height, layer.across());
  for (Index p = 0; p < particles.size(); ++p) {
    const double y = particles.position.component(0)[p];
    particles.velocity.component(1)[p] = begin(y);
    particles.velocity_gradient.component(1)[p] =
        (begin(y + spacing / 8) - begin(y - spacing / 8)) / (spacing / 4);
  }
  auto state = mpm::start(std::move(particles), grid, stages, {1});
  const Vector<1> sums =
      mpm::critical_sums(state.particles, grid, mpm::Linear{}, mpm::Apic{}, mpm::Order::usl);
  for (double time = 0; time < layer.duration;) {
    const double dt = mpm::stable_time_step(grid, state.rates, {}).dt;
    mpm::require_stable(state, stages, sums, dt);
    mpm::step(state, stages, dt, {1});
    time += dt;
  }
  double error = 0;
  for (Index p = 0; p < state.particles.size(); ++p) {
    if (!(state.particles.mass.component(0)[p] > 0)) continue;
    const double y = std::min(state.particles.position.component(0)[p], layer.height);
    error = std::max(error, std::abs(state.particles.velocity.component(1)[p] - exact(y)));
  }
  return error / exact(layer.height);
}

TEST(NewtonianLayer, MakesItsParabola) {
  const rheology::Newtonian law{.viscosity = 750, .bulk_modulus = 1e6, .density = 1000};
  const Layer layer{1, 18, 20, 5};  // eleven times the slowest decay, 4 rho H^2/(pi^2 mu) = 0.54 s
  const auto exact = [&](double y) { return 1000 * layer.along() / 750 * (y - y * y / 2); };

  const double h = 1.0 / 20;
  const double compression = 1000 * layer.across() / 1e6;
  EXPECT_LE(error_after(
                layer, law, [](double) { return 0; }, exact),
            h * h + compression + std::exp(-5 / 0.54));
}

TEST(BinghamLayer, MakesItsPlug) {
  // The plug moves at 0.9075540843 m/s above 0.6701255884 m.
  const double yield_surface = 0.6701255884;
  const rheology::ElasticHerschelBulkley law{.consistency = 750,
                                             .exponent = 1,
                                             .yield_stress = 1000,
                                             .shear_modulus = 1e6,
                                             .bulk_modulus = 2e6,
                                             .density = 1000};
  const Layer layer{1, 18, 20, 5};
  const auto exact = [&](double y) {
    const double sheared = std::min(y, yield_surface);
    return 1000 * layer.along() / 750 * (yield_surface * sheared - sheared * sheared / 2);
  };
  EXPECT_NEAR(exact(1), 0.9075540843, 1e-9);

  // Curvature ends at the yield surface, in the middle of a cell: h^2 of it; compression; stress over G.
  const double h = 1.0 / 20;
  const double compression = 1000 * layer.across() / 2e6;
  const double lag = 1000 * layer.along() / 1e6;
  EXPECT_LE(error_after(
                layer, law, [](double) { return 0; }, exact),
            h * h / (yield_surface * yield_surface) + compression + lag);
}

class Bagnold : public ::testing::TestWithParam<double> {};

/// Least lambda of (sqrt(s) f')' = -lambda f on 0 < s < 1 with f(1) = 0, no flux at s = 0: f is a series in
/// s^(3/2), s^(1/4) J_(-1/3)(4/3 sqrt(lambda) s^(3/4)) in closed form.
[[nodiscard]] double slowest_decay() {
  const auto at_base = [](double lambda) {
    double term = 1;
    double sum = 1;
    for (int k = 1; k < 20; ++k) {
      term *= -4 * lambda / (3.0 * k * (3 * k - 1));
      sum += term;
    }
    return sum;
  };
  double low = 0;  // where f(1) is positive
  double high = 3;
  for (int n = 0; n < 50; ++n) {
    const double middle = (low + high) / 2;
    (at_base(middle) > 0 ? low : high) = middle;
  }
  return low;
}

/// Time in which a small difference from Bagnold's profile falls by e, of its slowest mode: at a uniform I it
/// changes the stress by mu'(I) d sqrt(rho_s p) times its gradient, under p = rho g cos(theta) (H - y).
[[nodiscard]] double decay_time(const rheology::GranularElastoviscoplastic& law, const Layer& layer,
                                double inertial_number, double grain_size) {
  const double slope_of_mu =
      (law.mu_2 - law.mu_s) * law.I_0 / ((law.I_0 + inertial_number) * (law.I_0 + inertial_number));
  const double speed = std::sqrt(law.grain_density / law.density * layer.across());
  return std::pow(layer.height, 1.5) / (slowest_decay() * slope_of_mu * grain_size * speed);
}

/// From the exact profile, until a wrong one would be there but for e^-5 of it.
TEST_P(Bagnold, FlowOfGrainsStaysWithinOnePercentAt40Cells) {
  const rheology::GranularElastoviscoplastic law{.mu_s = 0.381863,
                                                 .mu_2 = 0.643468,
                                                 .I_0 = 0.279,
                                                 .grain_density = 2500,
                                                 .shear_modulus = 5e5,
                                                 .bulk_modulus = 1e6,
                                                 .density = 1500};
  constexpr double grain_size = 1.65e-3;  // [m]
  constexpr double num_decays = 5;
  Layer layer{0.1, GetParam(), 40, 0};
  const double slope = std::tan(layer.degrees * std::numbers::pi / 180);
  const double inertial_number = law.I_0 * (slope - law.mu_s) / (law.mu_2 - slope);
  const double scale = 2.0 / 3 * inertial_number / grain_size * std::sqrt(0.6 * layer.across());
  const auto exact = [&](double y) {
    const double depth = std::max(layer.height - y, 0.0);
    return scale * (std::pow(layer.height, 1.5) - std::pow(depth, 1.5));
  };
  layer.duration = num_decays * decay_time(law, layer, inertial_number, grain_size);

  const double error = error_after(layer, law, exact, exact);

  EXPECT_LE(error, 0.01 * (1 - std::exp(-num_decays)));
}

INSTANTIATE_TEST_SUITE_P(Slopes, Bagnold, ::testing::Values(22.5, 24.0, 26.0), [](const auto& test) {
  return "Tenths" + std::to_string(static_cast<int>(10 * test.param));
});

}  // namespace
}  // namespace scree::app::testing
