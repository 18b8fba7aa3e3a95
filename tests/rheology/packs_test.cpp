// Every law in packs of doubles: each lane has the bits of the same law in double. Compiled without
// contraction of products and sums, which a compiler may do in one of the two and not in the other.

#include "packs.hpp"

#include "points.hpp"
#include "typed_lists.hpp"

#include <scree/rheology/batch.hpp>
#include <scree/rheology/laws.hpp>

#include <gtest/gtest.h>

#include <vector>

namespace scree::rheology {
namespace {

template <class Law>
class EveryLawInPacks : public ::testing::Test {};
TYPED_TEST_SUITE(EveryLawInPacks, testing::Each<AnyLaw>, testing::EntryName);

/// One point per lane, of unlike densities (disconnected ones among them), gradients and sizes, in three
/// steps.
template <class Pack, class Law>
void expect_lanes_like_points() {
  using Input = typename Law::template Input<Pack>;
  constexpr Law law = typical<Law>();
  constexpr std::size_t num_lanes = Pack::size();
  const auto gradients = velocity_gradients();
  std::vector<Point<Law>> points(num_lanes, Point<Law>{law});
  auto state = initial_state<Law, Pack>();
  for (std::size_t n = 0; n < 3; ++n) {
    Deformation<Pack> deformation{};
    Pack size{};
    for (std::size_t lane = 0; lane < num_lanes; ++lane) {
      const auto& gradient = gradients[(n + lane) % gradients.size()];
      const double density = densities(law)[(3 + n + lane) % 4];
      const double size_here = 1e-3 * (1 + static_cast<double>(lane));
      for (std::size_t i = 0; i < 9; ++i) {
        deformation.velocity_gradient.components[i][lane] = gradient.components[i];
      }
      deformation.density[lane] = density;
      size[lane] = size_here;
      points[lane].step(gradient, density, 1e-3, size_here);
    }

    const auto response = law.update(deformation, filled_with<Input>(size), state, Pack(1e-3));
    state = response.state;

    for (std::size_t lane = 0; lane < num_lanes; ++lane) {
      for (std::size_t i = 0; i < 9; ++i) {
        const double in_pack = response.stress.components[i][lane];
        EXPECT_EQ(in_pack, points[lane].stress.components[i]) << "lane " << lane << ", step " << n;
      }
    }
  }
}

TYPED_TEST(EveryLawInPacks, HasTheBitsOfDoubleInEachLane) {
  expect_lanes_like_points<testing::Pack<2>, TypeParam>();
  expect_lanes_like_points<testing::Pack<4>, TypeParam>();
  expect_lanes_like_points<testing::Pack<8>, TypeParam>();
}

/// Columns of thirteen points: three packs of four and one point more.
template <class Law>
struct Batch {
  static constexpr std::size_t num_points = 13;
  static constexpr std::size_t num_states = Law::states.size();
  static constexpr std::size_t first_state = 10 + Law::inputs.size();
  std::vector<std::vector<double>> numbers{first_state + num_states + 6, std::vector<double>(num_points)};

  [[nodiscard]] LawColumns<Law> columns() {
    LawColumns<Law> result;
    for (std::size_t i = 0; i < 9; ++i) result.velocity_gradient[i] = numbers[i];
    result.density = numbers[9];
    for (std::size_t i = 0; i < Law::inputs.size(); ++i) result.inputs[i] = numbers[10 + i];
    for (std::size_t i = 0; i < num_states; ++i) {
      result.old_states[i] = result.states[i] = numbers[first_state + i];
    }
    for (std::size_t i = 0; i < 6; ++i) result.stress[i] = numbers[first_state + num_states + i];
    return result;
  }
};

template <class Real, class Law>
void expect_batch_like_points() {
  constexpr Law law = typical<Law>();
  Batch<Law> batch;
  std::vector<Point<Law>> points(Batch<Law>::num_points, Point<Law>{law});
  const auto gradients = velocity_gradients();
  for (std::size_t p = 0; p < points.size(); ++p) {
    for (std::size_t i = 0; i < 9; ++i) batch.numbers[i][p] = gradients[p % 8].components[i];
    batch.numbers[9][p] = densities(law)[p % 4];
    for (std::size_t i = 0; i < Law::inputs.size(); ++i) {
      batch.numbers[10 + i][p] = 1e-3 * (1 + static_cast<double>(p));
    }
    for (std::size_t i = 0; i < Law::states.size(); ++i) {
      batch.numbers[Batch<Law>::first_state + i][p] = Law::states[i].initial;
    }
  }

  for (int n = 0; n < 2; ++n) EXPECT_EQ(update_batch<Real>(law, batch.columns(), 1e-3), 0);

  for (std::size_t p = 0; p < points.size(); ++p) {
    for (int n = 0; n < 2; ++n) {
      points[p].step(gradients[p % 8], densities(law)[p % 4], 1e-3, 1e-3 * (1 + static_cast<double>(p)));
    }
    const Symmetric<double> expected = symmetric(points[p].stress);
    const auto stress = batch.columns().stress;
    EXPECT_EQ(stress[0][p], expected.xx) << p;
    EXPECT_EQ(stress[2][p], expected.zz) << p;
    EXPECT_EQ(stress[3][p], expected.xy) << p;
    EXPECT_EQ(stress[5][p], expected.yz) << p;
  }
}

TYPED_TEST(EveryLawInPacks, UpdatesABatchLikeItsPoints) {
  expect_batch_like_points<double, TypeParam>();
  expect_batch_like_points<testing::Pack<4>, TypeParam>();
}

TEST(UpdateBatch, RefusesColumnsOfUnlikeLengths) {
  Batch<Newtonian> batch;
  auto columns = batch.columns();
  columns.stress[5] = columns.stress[5].first(12);

  EXPECT_THROW(
      {
        try {
          update_batch(typical<Newtonian>(), columns, 1e-3);
        } catch (const InputError& error) {
          EXPECT_STREQ(error.what(),
                       "update_batch: every column must have a number for each point, as the density has");
          throw;
        }
      },
      InputError);
}

}  // namespace
}  // namespace scree::rheology
