// Every constitutive law through the material point core.

#include "scree/scene/chosen.hpp"

#include <scree/mpm/seed.hpp>
#include <scree/mpm/step.hpp>
#include <scree/rheology/laws.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace scree::app::testing {
namespace {

constexpr Index num_rows = 6;

/// A sheared periodic layer between two smooth walls, 0.6 m high.
template <class Law>
struct Layer {
  explicit Layer(const Law& law, Index num_columns, Index per_cell, Threads threads = {1})
      : grid{Vector<2>{0, 0}, Vector<2>{0.1, 0.1}, {num_columns, num_rows}, {true, false}} {
    const double length = 0.1 * static_cast<double>(num_columns);
    auto particles =
        mpm::seed_box<2, 2>(grid, Vector<2>{0, 0}, Vector<2>{length, 0.6}, {per_cell, per_cell}, law.density);
    for (const InputColumn& input : Law::inputs) {
      const std::size_t column =
          particles.add_column({std::string{input.name}, "", std::string{input.unit}}, 1);
      for (Index p = 0; p < particles.size(); ++p) particles.column(column).component(0)[p] = input.typical;
    }
    for (Index p = 0; p < particles.size(); ++p) {
      particles.density.component(0)[p] = law.density * 1.01;
      particles.velocity.component(0)[p] = 0.1 * std::sin(5 * particles.position.component(1)[p]);
    }
    stages.stress = std::make_unique<mpm::StressUpdateBy<2, 2, Law>>(
        law, particles, block_kernel(law, widest_instruction_set()));
    stages.transfer = mpm::make_transfer<2, 2>(mpm::Quadratic{}, mpm::Apic{});
    stages.boundaries.push_back(mpm::make_wall<2>(mpm::Slip{}, 1, mpm::Side::low));
    stages.boundaries.push_back(mpm::make_wall<2>(mpm::Slip{}, 1, mpm::Side::high));
    state = std::make_unique<mpm::State<2, 2>>(mpm::start(std::move(particles), grid, stages, threads));
  }

  void step(Threads threads = {1}) {
    mpm::step(*state, stages, mpm::stable_time_step(grid, state->rates, {}).dt, threads);
  }

  CartesianGrid<2> grid;
  mpm::Stages<2, 2> stages;
  std::unique_ptr<mpm::State<2, 2>> state;
};

/// No force acts along the layer but friction within it, so momentum along it stays and the shearing dies
/// away.
template <class Law>
void expect_friction_without_force(const Law& law) {
  Layer<Law> layer{law, 4, 2};
  const auto along = [&] {
    double momentum = 0;
    double energy = 0;
    const auto& particles = layer.state->particles;
    for (Index p = 0; p < particles.size(); ++p) {
      const double mass = particles.mass.component(0)[p];
      const double v = particles.velocity.component(0)[p];
      momentum += mass * v;
      energy += mass * v * v / 2;
    }
    return std::array{momentum, energy};
  };
  const auto before = along();

  constexpr int num_steps = 50;
  for (int i = 0; i < num_steps; ++i) layer.step();

  const auto after = along();
  const double largest = std::sqrt(2 * before[1] * law.density * 0.24);     // momentum if all moved one way
  EXPECT_NEAR(after[0], before[0], num_steps * 100 * round_off * largest);  // about 100 sums a step
  EXPECT_LT(after[1], before[1]);
  EXPECT_GT(after[1], 0);
}

/// All numbers of all points, one column after the other.
[[nodiscard]] std::vector<double> numbers_of(const mpm::Particles<2, 2>& particles) {
  std::vector<double> result;
  particles.for_each_column([&](const mpm::Column& column) {
    result.insert(result.end(), column.values().begin(), column.values().end());
  });
  return result;
}

TEST(EveryLaw, RunsThroughTheMaterialPointCore) {
  for_each_entry<rheology::AnyLaw>([](auto entry) {
    using Law = typename decltype(entry)::type;
    SCOPED_TRACE(Law::name);
    expect_friction_without_force(rheology::typical<Law>());
  });
}

TEST(EveryLaw, HasTheSameBitsForAnyNumberOfThreads) {
  for_each_entry<rheology::AnyLaw>([](auto entry) {
    using Law = typename decltype(entry)::type;
    SCOPED_TRACE(Law::name);
    const auto after_steps = [](int num_threads) {
      Layer<Law> layer{rheology::typical<Law>(), 80, 2};  // six blocks, two each of two colours
      for (int i = 0; i < 5; ++i) layer.step({num_threads});
      return numbers_of(layer.state->particles);
    };
    const auto by_one = after_steps(1);

    for (int num_threads = 2; num_threads <= 4; ++num_threads) {
      EXPECT_EQ(after_steps(num_threads), by_one) << num_threads << " threads";
    }
  });
}

/// The points without mass that fill packs are copies of the point before them, and stay so: they add nothing
/// to what bounds a step, and have no number that is not one.
TEST(EveryLaw, IsNotDisturbedByPointsThatFillPacks) {
  for_each_entry<rheology::AnyLaw>([](auto entry) {
    using Law = typename decltype(entry)::type;
    SCOPED_TRACE(Law::name);
    Layer<Law> layer{rheology::typical<Law>(), 5, 3};  // 270 points

    for (int i = 0; i < 3; ++i) layer.step();

    const auto& particles = layer.state->particles;
    for (const double number : numbers_of(particles)) EXPECT_TRUE(std::isfinite(number));
    Index num_fillers = 0;
    for (Index p = 1; p < particles.size(); ++p) {
      if (particles.mass.component(0)[p] != 0) continue;
      ++num_fillers;
      particles.for_each_column([&](const mpm::Column& column) {
        if (column.quantity() == particles.mass.quantity()) return;
        for (int c = 0; c < column.num_components(); ++c) {
          EXPECT_EQ(column.component(c)[p], column.component(c)[p - 1]) << column.quantity().name;
        }
      });
    }
    EXPECT_GT(num_fillers, 0);
  });
}

}  // namespace
}  // namespace scree::app::testing
