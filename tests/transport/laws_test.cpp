// What every law must hold to, over the whole list.

#include "lists.hpp"

#include <scree/transport/fluxes.hpp>
#include <scree/transport/laws.hpp>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>

namespace scree::transport {
namespace {

template <class L>
class EveryLaw : public ::testing::Test {
 public:
  using State = typename L::State;
  static constexpr int N = L::num_components;

  /// A state that can be: of one component between 0 and 1, else with components between -1 and 2.
  State draw() {
    std::uniform_real_distribution<double> one{0, 1};
    std::uniform_real_distribution<double> many{-1, 2};
    for (;;) {
      State u;
      for (double& component : u) component = N == 1 ? one(random) : many(random);
      if constexpr (HasAdmissibleStates<L>) {
        State less = u;  // away from the edge of what can be, where derivatives have no bound
        less[0] -= 0.1;
        less[N - 1] -= 0.1;
        if (!law.is_admissible(less)) continue;
      }
      return u;
    }
  }

  std::mt19937 random{3};
  L law{};
  std::vector<Vector<2>> normals{Vector<2>{1, 0}, Vector<2>{0, 1}, Vector<2>{-1, 0}, Vector<2>{0.6, -0.8}};
};
TYPED_TEST_SUITE(EveryLaw, test::Types<LawList<2>>);

TYPED_TEST(EveryLaw, TurnsItsFluxRoundWithTheNormal) {
  for (int trial = 0; trial < 100; ++trial) {
    const auto u = this->draw();
    for (const auto& normal : this->normals) {
      const auto forth = this->law.flux(u, normal);
      const auto back = this->law.flux(u, Vector<2>{-normal});
      for (std::size_t k = 0; k < u.size(); ++k) EXPECT_DOUBLE_EQ(forth[k], -back[k]);
    }
  }
}

TYPED_TEST(EveryLaw, BoundsItsWavesOnBothSides) {  // Eqs. (T3), (T16)
  if constexpr (TestFixture::N == 1) {
    // A mean slope of the flux is a slope somewhere in between; rounding of fluxes below 4 over parts of
    // 1/50.
    constexpr int parts = 50;
    for (int trial = 0; trial < 100; ++trial) {
      const double left = this->draw()[0];
      const double right = this->draw()[0];
      const double part = (right - left) / parts;
      const double rounding = 16 * round_off / std::abs(part);
      for (const auto& normal : this->normals) {
        const auto range = this->law.speed_range({left}, {right}, normal);
        for (int i = 0; i < parts; ++i) {
          const double u = left + i * part;
          const double slope =
              (this->law.flux({u + part}, normal)[0] - this->law.flux({u}, normal)[0]) / part;
          EXPECT_GE(slope, range.lowest - rounding);
          EXPECT_LE(slope, range.highest + rounding);
        }
      }
    }
  } else {
    // Central differences over 1e-5: third derivatives below 1e3, and eigenvectors a hundred times as wide.
    constexpr double step = 1e-5;
    constexpr double accuracy = step * step * 1e3 * 1e2;
    constexpr int size = TestFixture::N;
    for (int trial = 0; trial < 100; ++trial) {
      const auto left = this->draw();
      const auto right = this->draw();
      for (const auto& normal : this->normals) {
        const auto range = this->law.speed_range(left, right, normal);
        for (const auto& u : {left, right}) {
          Eigen::Matrix<double, size, size> jacobian;
          for (int k = 0; k < size; ++k) {
            auto below = u;
            auto above = u;
            below[static_cast<std::size_t>(k)] -= step;
            above[static_cast<std::size_t>(k)] += step;
            const auto flux_below = this->law.flux(below, normal);
            const auto flux_above = this->law.flux(above, normal);
            for (int row = 0; row < size; ++row) {
              const auto r = static_cast<std::size_t>(row);
              jacobian(row, k) = (flux_above[r] - flux_below[r]) / (2 * step);
            }
          }
          const Eigen::VectorXd speeds = Eigen::EigenSolver<Eigen::MatrixXd>{jacobian}.eigenvalues().real();
          EXPECT_GE(speeds.minCoeff(), range.lowest - accuracy);
          EXPECT_LE(speeds.maxCoeff(), range.highest + accuracy);
        }
      }
    }
  }
}

TYPED_TEST(EveryLaw, HasARangeWithinItsLargestSpeed) {
  for (int trial = 0; trial < 100; ++trial) {
    const auto left = this->draw();
    const auto right = this->draw();
    for (const auto& normal : this->normals) {
      const auto range = this->law.speed_range(left, right, normal);
      const double largest = this->law.max_speed(left, right, normal) * (1 + 4 * round_off);
      EXPECT_LE(range.lowest, range.highest);
      EXPECT_LE(-range.lowest, largest);
      EXPECT_LE(range.highest, largest);
    }
  }
}

TYPED_TEST(EveryLaw, PassesOnANaN) {
  const auto fine = this->draw();
  auto wrong = fine;
  wrong[0] = std::nan("");
  for (const auto& normal : {Vector<2>{1, 0}, Vector<2>{0.6, -0.8}}) {
    EXPECT_TRUE(std::isnan(KurganovTadmor{}(this->law, wrong, fine, normal).value[0]));
    EXPECT_TRUE(std::isnan(KurganovNoellePetrova{}(this->law, fine, wrong, normal).value[0]));
  }
}

TYPED_TEST(EveryLaw, LetsNoMassThroughAMirror) {  // Eq. (T8)
  if constexpr (HasMirror<TypeParam, 2>) {
    for (int trial = 0; trial < 100; ++trial) {
      const auto u = this->draw();
      for (const auto& normal : this->normals) {
        const auto mirrored = this->law.mirror(u, normal);
        const auto twice = this->law.mirror(mirrored, normal);
        // Three operations on numbers below 2, twice; times the speed, below 20, for the flux.
        for (std::size_t k = 0; k < u.size(); ++k) EXPECT_NEAR(twice[k], u[k], 24 * round_off);
        EXPECT_NEAR(KurganovTadmor{}(this->law, u, mirrored, normal).value[0], 0, 24 * 20 * round_off);
        EXPECT_NEAR(KurganovNoellePetrova{}(this->law, u, mirrored, normal).value[0], 0, 24 * 20 * round_off);
      }
    }
  }
}

TYPED_TEST(EveryLaw, ComesBackFromItsPrimitives) {
  if constexpr (HasPrimitives<TypeParam>) {
    for (int trial = 0; trial < 100; ++trial) {
      const auto u = this->draw();
      const auto back = this->law.conserved(this->law.primitive(u));
      // Six operations, no result above the energy, 2, but for squares of momentum over density, below 80.
      for (std::size_t k = 0; k < u.size(); ++k) EXPECT_NEAR(back[k], u[k], 6 * 80 * round_off);
    }
  }
}

TYPED_TEST(EveryLaw, DoesNotAdmitNaN) {
  if constexpr (HasAdmissibleStates<TypeParam>) {
    const auto u = this->draw();
    EXPECT_TRUE(this->law.is_admissible(u));
    for (std::size_t k = 0; k < u.size(); ++k) {
      auto wrong = u;
      wrong[k] = std::nan("");
      EXPECT_FALSE(this->law.is_admissible(wrong)) << k;
    }
  }
}

}  // namespace
}  // namespace scree::transport
