#include "dry_wall.hpp"
#include "typed_lists.hpp"

#include <scree/mpm/boundaries/contact.hpp>

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>
#include <variant>

namespace scree::mpm {
namespace {

/// Every rule by which a bed holds what slides on it.
using BedRules = std::variant<Sticks, Slides, Dry>;

template <class Rule>
class EveryBedRule : public ::testing::Test {
 protected:
  /// Velocities and normals of all ways, some into the wall and some away.
  template <class Body>
  static void for_each_contact(Body&& body) {
    std::mt19937 random{17};
    std::normal_distribution<double> draw{0, 1};
    const auto any = [&] { return Vector<3>{draw(random), draw(random), draw(random)}; };
    for (int i = 0; i < 200; ++i) body(any(), Vector<3>{any().normalized()});
  }
  static constexpr double mobility = 1e-3;  // [m/s/Pa]
  // A velocity is split, its part along the wall scaled and normalised: twenty operations on numbers up to 4.
  static constexpr double tolerance = 20 * 4 * round_off;
};
TYPED_TEST_SUITE(EveryBedRule, testing::Each<BedRules>, testing::EntryName);

TYPED_TEST(EveryBedRule, LetsNothingThrough) {  // Eq. (M63)
  for (const Hold hold : {Hold::pushes, Hold::pushes_and_pulls}) {
    const Contact<TypeParam> contact{TypeParam{}, hold};
    this->for_each_contact([&](const Vector<3>& velocity, const Vector<3>& normal) {
      const double away = contact.left(velocity, normal, this->mobility, {}).dot(normal);

      const double before = velocity.dot(normal);
      EXPECT_NEAR(away, before > 0 && hold == Hold::pushes ? before : 0, this->tolerance);
    });
  }
}

TYPED_TEST(EveryBedRule, DoesNotPullUnlessTold) {
  const Contact<TypeParam> contact{TypeParam{}};
  this->for_each_contact([&](const Vector<3>& velocity, const Vector<3>& normal) {
    if (velocity.dot(normal) > 0) {
      EXPECT_EQ(contact.left(velocity, normal, this->mobility, {}), velocity);
    }
  });
}

TYPED_TEST(EveryBedRule, SlowsAndNeverReverses) {
  for (const Hold hold : {Hold::pushes, Hold::pushes_and_pulls}) {
    const Contact<TypeParam> contact{TypeParam{}, hold};
    this->for_each_contact([&](const Vector<3>& velocity, const Vector<3>& normal) {
      const Vector<3> left = contact.left(velocity, normal, this->mobility, {});

      EXPECT_LE(left.norm(), velocity.norm() + this->tolerance);
      EXPECT_GE(left.dot(velocity), -this->tolerance);
    });
  }
}

TYPED_TEST(EveryBedRule, IsTheSameInAllDirections) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd{0.7, Eigen::Vector3d{1, 2, 3}.normalized()}.matrix();
  const Contact<TypeParam> contact{TypeParam{}};
  this->for_each_contact([&](const Vector<3>& velocity, const Vector<3>& normal) {
    const Vector<3> left = contact.left(velocity, normal, this->mobility, {});
    const Vector<3> turned = contact.left(turn * velocity, turn * normal, this->mobility, {});

    EXPECT_LE((turned - turn * left).norm(), 2 * this->tolerance);
  });
}

TEST(Slides, DoesNoWork) {  // what it takes of the velocity is along the normal, and what is left is not
  std::mt19937 random{19};
  std::normal_distribution<double> draw{0, 1};
  for (int i = 0; i < 100; ++i) {
    const Vector<3> velocity{draw(random), draw(random), draw(random)};
    const Vector<3> normal = Vector<3>{draw(random), draw(random), draw(random)}.normalized();

    const Vector<3> left = Contact<Slides>{}.left(velocity, normal, 1e-3, {});

    EXPECT_NEAR((left - velocity).dot(left), 0,
                20 * 16 * round_off);  // twenty operations on squares up to 16
  }
}

TEST(Dry, StaysInItsCone) {  // what friction takes is at most mu times what the wall pushes
  const Contact<Dry> contact{Dry{.friction = 0.5}};
  const Vector<3> up = Vector<3>::Unit(2);

  EXPECT_EQ(contact.left({3, 0, -2}, up, 1, {}), (Vector<3>{2, 0, 0}));
  EXPECT_EQ(contact.left({0, -0.9, -2}, up, 1, {}), (Vector<3>{0, 0, 0}));
}

TEST(Contact, HoldsWithoutPressureWhatIsPulled) {
  const Vector<3> up = Vector<3>::Unit(2);

  EXPECT_EQ((Contact<Dry>{{}, Hold::pushes_and_pulls}.left({3, 0, 2}, up, 1, {})), (Vector<3>{3, 0, 0}));
  EXPECT_EQ((Contact<Sticks>{{}, Hold::pushes_and_pulls}.left({3, 0, 2}, up, 1, {})), (Vector<3>{0, 0, 0}));
}

/// Where it fails: a node of another's normal is stopped on its own, so a bend of the wall costs speed:
/// 1 - cos of the angle, the square of the angle over two.
TEST(Slides, TakesTheSpeedThatABendOfTheWallTurns) {
  const double bend = 0.01;

  const Vector<3> left = Contact<Slides>{}.left({1, 0, 0}, {-std::sin(bend), std::cos(bend), 0}, 1, {});

  EXPECT_NEAR(1 - left.norm(), bend * bend / 2, bend * bend * bend * bend / 24 + 20 * round_off);
}

TEST(ChangeVelocity, ChangesTheIncrementAlikeAndLeavesEmptyNodesAlone) {
  const NodeRecord layout{.num_velocities = 2, .has_increment = true};
  std::array<double, 8> node{2, 3, -4, 0, 10, 20, 0, 0};
  std::array<double, 8> empty{0, 3, -4, 0, 10, 20, 0, 0};

  for (auto* record : {&node, &empty}) {
    change_velocity(layout, record->data(), [](const Vector<3>& v) { return Vector<3>{v[0] + 1, 0, 7}; });
  }

  EXPECT_EQ(node, (std::array<double, 8>{2, 4, 0, 0, 11, 24, 0, 0}));
  EXPECT_EQ(empty, (std::array<double, 8>{0, 3, -4, 0, 10, 20, 0, 0}));
}

}  // namespace
}  // namespace scree::mpm
