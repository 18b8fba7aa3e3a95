#include "bodies.hpp"
#include "messages.hpp"

#include <scree/mpm/geostatic.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace scree::mpm {
namespace {

constexpr double gravity = 9.81;  // [m/s^2]
constexpr Fluid soft{.bulk_modulus = 1e5, .reference_density = 1000, .viscosity = 0};

/// A column of 10 cells of 0.1 m, filled up to 0.8 m, at rest under its own weight.
struct Column10 {
  explicit Column10(double surface_pressure = 0, const Fluid& law = soft, Threads threads = {1},
                    Index per_cell = 3) {
    const auto grid = cube<1>(10, 0.1, false);
    particles = filled<1>(grid, per_cell);
    const StressUpdateBy<1, 1, Fluid> stress{law, particles};
    before = particles;
    set_geostatic(particles, stress, 0, surface, gravity, surface_pressure, threads);
    pressure.resize(static_cast<std::size_t>(particles.size()));
    stress.pressure(particles, pressure);
  }
  static constexpr double surface = 0.8;  // [m]
  Particles<1> particles;
  Particles<1> before;
  std::vector<double> pressure;
};

/// Eq. (M24): dp/dz = rho(p) g has K + p = (K + p_0) exp(rho_0 g z/K).
void expect_balance(double surface_pressure, const Fluid& law = soft) {
  const Column10 column{surface_pressure, law};

  for (Index p = 0; p < column.particles.size(); ++p) {
    const double depth = Column10::surface - column.particles.position.component(0)[p];
    if (depth <= 0) continue;
    const double K = law.bulk_modulus;
    const double exponent = law.reference_density * gravity * depth / K;
    const double expected = K * std::expm1(exponent) + surface_pressure * std::exp(exponent);
    // What the rule of three points leaves out, exponent^7/2016000 of the density (M201); the pressure's
    // rounding is K round_off.
    const double truncation = std::pow(exponent, 7) / 2016000 * std::exp(exponent);
    const double tolerance = (K + surface_pressure) * (truncation + 16 * round_off);
    EXPECT_NEAR(column.pressure[static_cast<std::size_t>(p)], expected, tolerance);
  }
}

TEST(SetGeostatic, BalancesTheWeightAbove) {
  expect_balance(0);
}

TEST(SetGeostatic, BalancesAPressureOnTheSurfaceToo) {
  expect_balance(2e4);
}

/// Twice as dense at its base as on top: what the rule leaves out is 1e-7 there, far from round-off.
TEST(SetGeostatic, BalancesTheWeightOfVerySoftMaterial) {
  const Fluid very_soft{.bulk_modulus = 1e4, .reference_density = 1000, .viscosity = 0};
  expect_balance(0, very_soft);
  expect_balance(2e3, very_soft);
}

/// Material three times as stiff from 0.5 % of compression on.
struct Stiffening : Fluid {
  static constexpr double yield = 5e-3;
  template <class Real>
  [[nodiscard]] Response<Real, State<Real>> update(const Deformation<Real>& deformation,
                                                   const Input<Real>& /*input*/, const State<Real>& /*old*/,
                                                   Real /*dt*/) const noexcept {
    const Real compression = deformation.density / reference_density - 1;
    const Real more = 2 * std::max(compression - yield, Real{0});
    return {isotropic(-bulk_modulus * (compression + more)), {}};
  }
};

/// The integral of dp/rho beyond the strain s_y of yield: K/rho_0 (3 s - 2 s_y) = g z.  Eq. (M201)
TEST(SetGeostatic, BalancesTheWeightOfMaterialWhoseStiffnessJumps) {
  auto particles = filled<1>(cube<1>(10, 0.1, false), 3);
  const StressUpdateBy<1, 1, Stiffening> stress{{soft}, particles};
  set_geostatic(particles, stress, 0, Column10::surface, gravity);

  const double K = soft.bulk_modulus;
  const double yield_strain = std::log1p(Stiffening::yield);
  double worst = 0;
  for (Index p = 0; p < particles.size(); ++p) {
    const double depth = Column10::surface - particles.position.component(0)[p];
    if (depth <= 0) continue;
    const double load = soft.reference_density * gravity * depth / K;
    const double s = load < yield_strain ? load : (load + 2 * yield_strain) / 3;
    const double error = std::log(particles.density.component(0)[p] / soft.reference_density) - s;
    EXPECT_LE(std::abs(error), 0.0175 * s * s * 2 / 3 + 16 * round_off);
    worst = std::max(worst, std::abs(error));
  }
  EXPECT_GT(worst, 1e-8);  // the bound is of use
}

TEST(SetGeostatic, HasTheSameBitsForAnyNumberOfThreads) {
  const Column10 one{0, soft, Threads{1}, 50};
  const Column10 many{0, soft, Threads{4}, 50};

  EXPECT_TRUE(std::ranges::equal(one.particles.density.values(), many.particles.density.values()));
  EXPECT_TRUE(std::ranges::equal(one.particles.mass.values(), many.particles.mass.values()));
}

/// Dust bears nothing, in whichever thread; the first point, whose depth is told, is the lowest.
TEST(SetGeostatic, NamesTheLawThatCannotBearTheWeight) {
  EXPECT_EQ(message_of<RunError>([] {
              Column10{0, dust, Threads{4}, 50};
            }),
            "the law 'fluid' has no density at which it rests 0.799000 m below a free surface");
}

TEST(SetGeostatic, KeepsTheVolumeOfEachPoint) {
  const Column10 column;

  for (Index p = 0; p < column.particles.size(); ++p) {
    const double volume = column.particles.mass.component(0)[p] / column.particles.density.component(0)[p];
    const double before = column.before.mass.component(0)[p] / column.before.density.component(0)[p];
    EXPECT_NEAR(volume, before, 4 * round_off * before);
  }
}

TEST(SetGeostatic, LeavesPointsAboveTheSurfaceAlone) {
  const Column10 column;

  for (Index p = 0; p < column.particles.size(); ++p) {
    if (column.particles.position.component(0)[p] < Column10::surface) continue;
    EXPECT_EQ(column.particles.density.component(0)[p], column.before.density.component(0)[p]);
    EXPECT_EQ(column.particles.mass.component(0)[p], column.before.mass.component(0)[p]);
  }
}

/// Height of the topmost of 16 points of a soft column with rho_0 g H/K = 0.3, of 8 cells, after it has come
/// to rest over the height at which it was laid.
[[nodiscard]] double height_kept(bool is_settled) {
  constexpr double H = 1;
  constexpr double K = 1000 * gravity * H / 0.3;
  const double c = std::sqrt(K / 1000);
  const Fluid thick{
      .bulk_modulus = K, .reference_density = 1000, .viscosity = 1000 * c * H / 2};  // hardly swings
  const CartesianGrid<1> grid{Vector<1>{0.0}, Vector<1>{0.125}, {10}, {false}};
  auto particles = seed_box<1, 1>(grid, Vector<1>{0.0}, Vector<1>{H}, {2}, 1000);
  auto stages = stages_of<1, 1>(particles, Quadratic{}, Apic{}, thick);
  stages.gravity = {-gravity};
  stages.boundaries.push_back(make_wall<1>(NoSlip{}, 0, Side::low));
  if (is_settled) set_geostatic(particles, *stages.stress, 0, H, gravity);
  const auto top = [](const Particles<1>& points) { return largest(points.position); };
  const double first = top(particles);
  auto state = start(std::move(particles), grid, stages, Threads{1});
  for (double t = 0; t < 20 * H / c;) {
    const double dt = stable_time_step(grid, state.rates, {}).dt;
    step(state, stages, dt, Threads{1});
    t += dt;
  }
  return top(state.particles) / first;
}

/// What bears nothing at first sinks to where it bears its weight: dz = dZ/(1 + r (1 - Z/H)).  Eq. (M187)
TEST(SetGeostatic, SparesASoftColumnItsFall) {
  constexpr double ratio = 0.3;
  constexpr double top = 1 - 1.0 / 32;  // of the height: the topmost of 16 points
  const double sunk = std::log((1 + ratio) / (1 + ratio - ratio * top)) / ratio / top;  // 0.871

  const double of_a_cell = ratio / 8 * (ratio / 8);  // what forces on the mesh balance to
  EXPECT_NEAR(height_kept(false), sunk, of_a_cell);
  EXPECT_NEAR(height_kept(true), 1, of_a_cell);
}

}  // namespace
}  // namespace scree::mpm
