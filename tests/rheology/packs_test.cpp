// Every law in packs of doubles, walls' too: each lane has the bits of the same law in double. Compiled
// without contraction of products and sums, which a compiler may do in one of the two and not in the other.

#include "packs.hpp"

#include "points.hpp"
#include "typed_lists.hpp"
#include "wall_contacts.hpp"

#include <scree/rheology/laws.hpp>
#include <scree/rheology/logarithmic_strain.hpp>
#include <scree/rheology/walls.hpp>

#include <gtest/gtest.h>

#include <cstddef>
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

template <class Law>
class EveryWallLawInPacks : public ::testing::Test {};
TYPED_TEST_SUITE(EveryWallLawInPacks, testing::Each<AnyWallLaw>, testing::EntryName);

TYPED_TEST(EveryWallLawInPacks, HasTheBitsOfDoubleInEachLane) {
  using Pack = testing::Pack<4>;
  constexpr TypeParam law = typical<TypeParam>();
  const auto input = typical_input<TypeParam, double>();
  for (std::size_t first = 0; first + 4 <= speeds.size(); ++first) {
    Pack speed;
    WallContact<Pack> contact;
    for (std::size_t lane = 0; lane < 4; ++lane) {
      speed[lane] = speeds[first + lane];
      contact.pressure[lane] = pressures[(first + 2 * lane) % pressures.size()];
      contact.mobility[lane] = mobilities[(first + lane) % mobilities.size()];
    }

    const Pack slowed = law.slowed(speed, contact, typical_input<TypeParam, Pack>());
    const Pack traction = law.traction(contact.pressure, speed, typical_input<TypeParam, Pack>());

    for (std::size_t lane = 0; lane < 4; ++lane) {
      const WallContact<double> alone{contact.pressure[lane], contact.mobility[lane]};
      EXPECT_EQ(slowed[lane], law.slowed(double{speed[lane]}, alone, input));
      EXPECT_EQ(traction[lane], law.traction(alone.pressure, double{speed[lane]}, input));
    }
  }
}

/// Lanes inside the reach of the series beside lanes that are not.
TEST(TrialStrainInPacks, HasTheBitsOfDoubleInEachLane) {
  using Pack = testing::Pack<4>;
  const auto gradients = velocity_gradients();
  Tensor<Pack> gradient;
  Tensor<Pack> strain;
  for (std::size_t i = 0; i < 9; ++i) {
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const double size = lane % 2 == 0 ? 0.01 : 0.2;
      gradient.components[i][lane] = gradients[lane + 1].components[i];
      strain.components[i][lane] = size * deviator(symmetric_part(gradients[lane])).components[i];
    }
  }

  const auto in_packs = trial_strain(symmetric(strain), gradient, Pack(0.1)).tensor();

  for (std::size_t lane = 0; lane < 4; ++lane) {
    Tensor<double> strain_alone;
    for (std::size_t i = 0; i < 9; ++i) strain_alone.components[i] = strain.components[i][lane];
    const auto alone = trial_strain(symmetric(strain_alone), gradients[lane + 1], 0.1).tensor();
    for (std::size_t i = 0; i < 9; ++i) {
      const double in_pack = in_packs.components[i][lane];
      EXPECT_EQ(in_pack, alone.components[i]) << "lane " << lane;
    }
  }
}

}  // namespace
}  // namespace scree::rheology
