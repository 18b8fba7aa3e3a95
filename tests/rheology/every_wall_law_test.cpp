#include "derivative.hpp"
#include "points.hpp"
#include "typed_lists.hpp"
#include "wall_contacts.hpp"

#include <scree/rheology/walls.hpp>

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>

namespace scree::rheology {
namespace {

using testing::Dual;

template <class Law>
class EveryWallLaw : public ::testing::Test {
 protected:
  static constexpr Law law = typical<Law>();

  template <class Real = double>
  [[nodiscard]] static auto input() {
    return typical_input<Law, Real>();
  }
  /// One number as every input, in SI.
  template <class Real = double>
  [[nodiscard]] static auto input(double value) {
    return filled_with<typename Law::template Input<Real>>(Real(value));
  }
  [[nodiscard]] static double traction(double pressure, double speed) {
    return law.traction(pressure, speed, input());
  }
};
TYPED_TEST_SUITE(EveryWallLaw, testing::Each<AnyWallLaw>, testing::EntryName);

/// Some 20 operations, on terms that are at most the speed or what friction takes from it.
[[nodiscard]] double rounding(double speed, double loss) {
  return 20 * round_off * (speed + loss);
}

TYPED_TEST(EveryWallLaw, DescribesEachNumberItReads) {
  using Input = typename TypeParam::template Input<double>;

  EXPECT_EQ(TypeParam::inputs.size() * sizeof(double), std::is_empty_v<Input> ? 0 : sizeof(Input));
  EXPECT_EQ(TypeParam::parameters.size() * sizeof(double), sizeof(TypeParam));
  EXPECT_NO_THROW(validate(this->law));
}

TYPED_TEST(EveryWallLaw, NeverDrives) {  // Eq. (R160): the power of friction is -traction speed
  for (const double p : pressures) {
    for (const double v : speeds) EXPECT_GE(this->traction(p, v), 0) << p << ' ' << v;
  }
}

TYPED_TEST(EveryWallLaw, SlowsAndNeverReverses) {  // Eq. (R161)
  for (const double p : pressures) {
    for (const double mobility : mobilities) {
      for (const double v : speeds) {
        const double slowed = this->law.slowed(v, WallContact<double>{p, mobility}, this->input());

        EXPECT_GE(slowed, 0) << p << ' ' << mobility << ' ' << v;
        EXPECT_LE(slowed, v * (1 + 4 * round_off)) << p << ' ' << mobility << ' ' << v;
      }
    }
  }
}

TYPED_TEST(EveryWallLaw, IsBackwardEuler) {  // Eq. (R161)
  for (const double p : pressures) {
    for (const double mobility : mobilities) {
      for (const double v : speeds) {
        const double slowed = this->law.slowed(v, WallContact<double>{p, mobility}, this->input());
        const double held = mobility * this->traction(p, 0);
        const double loss = mobility * this->traction(p, slowed);

        if (slowed > 0) {
          EXPECT_NEAR(slowed + loss, v, rounding(v, held + loss)) << p << ' ' << mobility;
        } else {
          EXPECT_LE(v, held + rounding(v, held)) << p << ' ' << mobility;
        }
      }
    }
  }
}

TYPED_TEST(EveryWallLaw, RubsMoreUnderMorePressure) {
  for (const double mobility : mobilities) {
    for (const double v : speeds) {
      for (std::size_t i = 1; i < pressures.size(); ++i) {
        const WallContact<double> light{pressures[i - 1], mobility};
        const WallContact<double> heavy{pressures[i], mobility};

        EXPECT_LE(this->traction(light.pressure, v), this->traction(heavy.pressure, v));
        EXPECT_GE(this->law.slowed(v, light, this->input()) + rounding(v, 0),
                  this->law.slowed(v, heavy, this->input()));
      }
    }
  }
}

/// Its own logarithmic slope is at most 2 (a drag with the square of the speed).
TYPED_TEST(EveryWallLaw, HasNoJumpInSpeed) {
  const double p = 1000;
  const double step = 1e-7;  // [-], relative
  for (double v = 1e-4; v < 100; v *= 1 + step * 1e4) {
    const double here = this->traction(p, v);

    EXPECT_NEAR(this->traction(p, v * (1 + step)), here, 2.1 * step * here) << v;
  }
}

TYPED_TEST(EveryWallLaw, HoldsWhatIsAtRest) {
  for (const double p : pressures) {
    EXPECT_EQ(this->law.slowed(0.0, WallContact<double>{p, 1e-3}, this->input()), 0);
  }
}

[[nodiscard]] Eigen::Matrix3d turn() {
  return Eigen::AngleAxisd{1.0, Eigen::Vector3d{1, 2, 2} / 3}.toRotationMatrix();
}

TYPED_TEST(EveryWallLaw, IsTheSameInAllDirections) {  // Eq. (R162)
  const Vector<3> normal = Vector<3>::UnitY();
  for (const double approach : {-0.1, 0.01, 2.0}) {  // whether 0 touches would be rounding's choice
    for (const double v : speeds) {
      const Vector<3> velocity{0.6 * v, -approach, 0.8 * v};

      const Vector<3> here = slide(this->law, velocity, normal, 1e-3, this->input());
      const Vector<3> turned = slide<3>(this->law, turn() * velocity, turn() * normal, 1e-3, this->input());

      // Two rotations of 9 products and sums; rounding of the normal mixes speed into the approach and, by
      // the law's friction or drag (below 10 times the approach at these speeds), back into the speed.
      EXPECT_LE((turned - turn() * here).norm(), 10 * 60 * round_off * (v + std::abs(approach)));
    }
  }
}

TYPED_TEST(EveryWallLaw, StaysInItsConeAndSlidesAlongTheWall) {  // Eqs. (R160)-(R162)
  const Vector<2> normal = Vector<2>::UnitY();
  const double mobility = 1e-3;
  for (const double v : speeds) {
    const double approach = 0.05;

    const Vector<2> left = slide(this->law, Vector<2>{v, -approach}, normal, mobility, this->input());

    const double shear = (v - left[0]) / mobility;
    const double bound =
        std::max(this->traction(approach / mobility, 0), this->traction(approach / mobility, left[0]));
    EXPECT_EQ(left[1], 0);
    EXPECT_LE(shear, bound + rounding(v, approach) / mobility);
  }
}

TYPED_TEST(EveryWallLaw, LeavesAloneWhatMovesAway) {
  const Vector<2> away{3, 0.1};

  EXPECT_EQ(slide<2>(this->law, away, Vector<2>::UnitY(), 1e-3, this->input()), away);
}

TYPED_TEST(EveryWallLaw, HasTheDerivativeThatItsDualNumbersCarry) {
  const double step = std::cbrt(round_off);  // balances truncation and rounding of a central difference
  const double mobility = 1e-6;
  for (const double v : {0.013, 0.1, 1.0, 30.0}) {
    const WallContact<Dual> contact{1e3, mobility};
    const auto after = [&](double speed) {
      return this->law.slowed(speed, WallContact<double>{1e3, mobility}, this->input());
    };

    const Dual exact = this->law.slowed(Dual{v, 1}, contact, this->template input<Dual>());

    const double difference = (after(v * (1 + step)) - after(v * (1 - step))) / (2 * v * step);
    // The third derivative is of the order of the second power of 1/v here.
    EXPECT_NEAR(exact.value, after(v), rounding(v, 0));
    EXPECT_NEAR(exact.slope, difference, step * step + 20 * round_off / step) << v;
  }
}

TYPED_TEST(EveryWallLaw, DoesNotHideANan) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto input = this->input();

  EXPECT_TRUE(std::isnan(this->law.slowed(nan, WallContact<double>{1e3, 1e-6}, input)));
  EXPECT_TRUE(std::isnan(this->law.slowed(1.0, WallContact<double>{nan, 1e-6}, input)));
  EXPECT_TRUE(std::isnan(this->law.slowed(1.0, WallContact<double>{1e3, nan}, input)));
  EXPECT_TRUE(std::isnan(slide<2>(this->law, Vector<2>{1, nan}, Vector<2>::UnitY(), 1e-6, input)[0]));
  if (!TypeParam::inputs.empty()) {
    EXPECT_TRUE(std::isnan(this->law.slowed(1.0, WallContact<double>{1e3, 1e-6}, this->input(nan))));
  }
}

/// What validate() says, empty if it accepts.
template <class Law>
[[nodiscard]] std::string complaint(const Law& law) {
  try {
    validate(law);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TYPED_TEST(EveryWallLaw, RefusesParametersOutOfTheirBounds) {
  for (const auto& parameter : TypeParam::parameters) {
    TypeParam broken = this->law;
    broken.*parameter.member = parameter.bound == Bound::positive ? 0 : -1;
    EXPECT_NE(complaint(broken), "") << parameter.name;
    broken.*parameter.member = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(complaint(broken), "") << parameter.name;
    if (parameter.exceeds == nullptr) continue;
    broken.*parameter.member = broken.*parameter.exceeds;
    EXPECT_NE(complaint(broken), "") << parameter.name;
  }
}

TEST(WallLaws, NameParameterValueAndBound) {
  Voellmy snow = typical<Voellmy>();
  snow.turbulence = 0;
  PouliquenForterre bed = typical<PouliquenForterre>();
  bed.mu_3 = 0.38;
  PouliquenForterre abrupt = typical<PouliquenForterre>();
  abrupt.weakening = 1;

  EXPECT_EQ(complaint(Coulomb{.friction = -0.1}), "coulomb: friction = -0.1: must be finite and at least 0");
  EXPECT_EQ(complaint(MaterialFriction{.share = 0}),
            "material_friction: share = 0: must be finite and above 0");
  EXPECT_EQ(complaint(snow), "voellmy: turbulence = 0 m/s^2: must be finite and above 0");
  EXPECT_EQ(complaint(bed), "pouliquen_forterre: mu_3 = 0.38: must exceed mu_1 = 0.382");
  EXPECT_EQ(complaint(abrupt), "pouliquen_forterre: weakening = 1: must be finite and above 0 and below 1");
}

}  // namespace
}  // namespace scree::rheology
