// Every constitutive law through the material point core.

#include "scree/chosen.hpp"

#include <scree/mpm/seed.hpp>
#include <scree/mpm/step.hpp>
#include <scree/rheology/laws.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace scree::app::testing {
namespace {

/// A sheared periodic layer between two smooth walls: no force along it but friction within, so momentum
/// along it stays and the shearing dies away.
template <class Law>
void expect_friction_without_force(const Law& law) {
  const CartesianGrid<2> grid{Vector<2>{0, 0}, Vector<2>{0.1, 0.1}, {4, 6}, {true, false}};
  auto particles = mpm::seed_box<2, 2>(grid, Vector<2>{0, 0}, Vector<2>{0.4, 0.6}, {2, 2}, law.density);
  for (const InputColumn& input : Law::inputs) {
    const std::size_t column =
        particles.add_column({std::string{input.name}, "", std::string{input.unit}}, 1);
    for (Index p = 0; p < particles.size(); ++p) particles.column(column).component(0)[p] = input.typical;
  }
  for (Index p = 0; p < particles.size(); ++p) {
    particles.density.component(0)[p] = law.density * 1.01;
    particles.velocity.component(0)[p] = 0.1 * std::sin(5 * particles.position.component(1)[p]);
  }
  mpm::Stages<2, 2> stages;
  stages.stress = std::make_unique<mpm::StressUpdateBy<2, 2, Law>>(law, particles);
  stages.transfer = mpm::make_transfer<2, 2>(mpm::Quadratic{}, mpm::Apic{});
  stages.boundaries.push_back(mpm::make_wall<2>(mpm::Slip{}, 1, mpm::Side::low));
  stages.boundaries.push_back(mpm::make_wall<2>(mpm::Slip{}, 1, mpm::Side::high));
  auto state = mpm::start(std::move(particles), grid, stages, {1});
  const auto along = [&] {
    double momentum = 0;
    double energy = 0;
    for (Index p = 0; p < state.particles.size(); ++p) {
      const double mass = state.particles.mass.component(0)[p];
      const double v = state.particles.velocity.component(0)[p];
      momentum += mass * v;
      energy += mass * v * v / 2;
    }
    return std::array{momentum, energy};
  };
  const auto before = along();

  constexpr int num_steps = 50;
  for (int i = 0; i < num_steps; ++i) {
    mpm::step(state, stages, mpm::stable_time_step(grid, state.rates, {}).dt, {1});
  }

  const auto after = along();
  const double largest = std::sqrt(2 * before[1] * law.density * 0.24);     // momentum if all moved one way
  EXPECT_NEAR(after[0], before[0], num_steps * 100 * round_off * largest);  // about 100 sums a step
  EXPECT_LT(after[1], before[1]);
  EXPECT_GT(after[1], 0);
}

TEST(EveryLaw, RunsThroughTheMaterialPointCore) {
  for_each_entry<rheology::AnyLaw>([](auto entry) {
    using Law = typename decltype(entry)::type;
    SCOPED_TRACE(Law::name);
    expect_friction_without_force(rheology::typical<Law>());
  });
}

}  // namespace
}  // namespace scree::app::testing
