// Manufactured solutions: the order of the whole method, and what linear shapes lose.

#include "manufactured_run.hpp"
#include "schemes.hpp"

#include <gtest/gtest.h>

namespace scree::mpm {
namespace {

/// rho_0 b from the motion and the law alone, by central differences of exact places and of the nominal
/// stress P = J sigma F^-T, over steps of `delta` [m] and delta/c.
template <class Motion>
Vector<2> force_by_differences(const Motion& motion, const Vector<2>& X, double t, double delta) {
  const auto nominal = [&](const Vector<2>& at) {
    const Matrix<2> F = motion.gradient(at, t);
    const Tensor<double> sigma = rubber.stress(state_of(F));
    Matrix<2> cauchy;
    cauchy << sigma(0, 0), sigma(0, 1), sigma(1, 0), sigma(1, 1);
    Matrix<2> P = F.determinant() * cauchy * F.inverse().transpose();
    return P;
  };
  const double dt = delta / rubber.wave_speed();
  Vector<2> b = (motion.place(X, t + dt) - 2 * motion.place(X, t) + motion.place(X, t - dt)) / (dt * dt);
  for (int d = 0; d < 2; ++d) {
    Vector<2> shift = Vector<2>::Zero();
    shift[d] = delta;
    b -= (nominal(X + shift) - nominal(X - shift)).col(d) / (2 * delta * rubber.density);
  }
  return b;
}

template <class Motion>
void expect_the_force_of_the_exact_stress(const Motion& motion) {
  for (const double t : {0.0012, 0.0041}) {
    for (const Vector<2>& X : {Vector<2>{0.31, 0.42}, Vector<2>{0.55, 0.83}, Vector<2>{0.7, 0.21}}) {
      const Vector<2> exact = motion.force(motion.place(X, t), t);
      const double coarse = (force_by_differences(motion, X, t, 2e-3) - exact).norm();
      const double fine = (force_by_differences(motion, X, t, 1e-3) - exact).norm();
      // C delta^2 (1 + c delta^2): a quarter, and as small as the motion is smooth over the ring's width.
      EXPECT_NEAR(coarse / fine, 4, 0.1);
      EXPECT_LE(fine, 1e-3 * exact.norm());
    }
  }
}

TEST(ManufacturedForce, OfTheAxisAlignedSwingIsThatOfItsStress) {  // Eq. (M82)
  expect_the_force_of_the_exact_stress(AxisAlignedSwing{0.05});
}

TEST(ManufacturedForce, OfTheTurningRingIsThatOfItsStress) {  // Eq. (M84)
  expect_the_force_of_the_exact_stress(TurningRing{0.3});
}

template <class Motion>
void expect_gradients_of_places(const Motion& motion) {
  constexpr double delta = 1e-5;  // [m]; errors delta^2 and round-off/delta
  const Vector<2> X{0.31, 0.42};
  for (int d = 0; d < 2; ++d) {
    Vector<2> shift = Vector<2>::Zero();
    shift[d] = delta;
    const Vector<2> column =
        (motion.place(X + shift, 0.0012) - motion.place(X - shift, 0.0012)) / (2 * delta);
    EXPECT_LE((column - motion.gradient(X, 0.0012).col(d)).norm(), 1e-7);
  }
}

TEST(ManufacturedMotion, HasTheGradientOfItsPlaces) {
  expect_gradients_of_places(AxisAlignedSwing{0.05});
  expect_gradients_of_places(TurningRing{0.3});
}

/// Waves run too slow by the square of the spacing: C h^2 (1 + c h), of the order a tenth may be missing.
constexpr double second_order = 1.9;

TEST(AxisAlignedSwing, ConvergesWithSecondOrderUnderQuadraticShapes) {
  constexpr double amplitude = 0.01;
  for (const auto& [rule, lag] : {std::pair{AnyTransfer{Apic{}}, 13.0 / 120},
                                  {Aflip{1}, 13.0 / 120},
                                  {Tpic{}, 1.0 / 8},
                                  {PicFlip{1}, 1.0 / 4}}) {
    const auto errors = manufactured_errors<3>(AxisAlignedSwing{amplitude}, 8, Quadratic{}, rule);

    for (std::size_t i = 1; i < 3; ++i) EXPECT_GT(std::log2(errors[i - 1] / errors[i]), second_order);
    // A free wave would lag by lag (k h)^2, Eq. (M86), over the half swing of pi.
    EXPECT_LT(errors[2], amplitude * std::numbers::pi * lag * std::pow(2 * std::numbers::pi / 32, 2));
  }
}

TEST(TurningRing, ConvergesWithSecondOrderUnderQuadraticShapes) {
  for (const AnyTransfer& rule : every<AnyTransfer>()) {
    const auto errors = manufactured_errors<2>(TurningRing{0.3}, 16, Quadratic{}, rule);

    EXPECT_GT(std::log2(errors[0] / errors[1]), second_order);
  }
}

TEST(AxisAlignedSwing, ConvergesWithSecondOrderWithEveryExtraPass) {  // Eqs. (M126)-(M132)
  for (const Extras& extras :
       {Extras{Order::musl}, Extras{Order::usf},
        Extras{Order::usl, {.volume_change = true, .pressure = true}}, Extras{Order::usl, {}, 2}}) {
    const bool is_filtered = extras.xpic_order > 0;
    const AnyTransfer rule = is_filtered ? AnyTransfer{PicFlip{1}} : AnyTransfer{Apic{}};
    // What the filter takes falls with the fourth power of the spacing: on 8 cells it is not yet small.
    const Index coarsest = is_filtered ? 16 : 8;
    const auto errors = manufactured_errors<2>(AxisAlignedSwing{0.01}, coarsest, Quadratic{}, rule, extras);

    EXPECT_GT(std::log2(errors[0] / errors[1]), second_order);
  }
}

TEST(AxisAlignedSwing, ConvergesWithSecondOrderUnderMeansOfCellsThatNoPointLeaves) {  // Eqs. (M131), (M132)
  for (const Averaging& averaging : {Averaging{true, false}, Averaging{false, true}, Averaging{true, true}}) {
    for (const AnyShape& shape : every<AnyShape>()) {
      const auto errors =
          manufactured_errors<2>(AxisAlignedSwing{0.002}, 8, shape, Apic{}, {Order::usl, averaging});

      EXPECT_GT(std::log2(errors[0] / errors[1]), second_order);
    }
  }
}

TEST(AxisAlignedSwing, GathersNoiseUnderFlipOfWhichXpicLeavesLess) {
  // At a strain of 0.31 points stand for more or less of their cells than these hold. What of that nodes
  // cannot see stays under FLIP, most where stress comes first and takes no energy; XPIC drops it.
  const auto error = [](const Extras& extras) {
    return manufactured_errors<1>(AxisAlignedSwing{0.05}, 32, Quadratic{}, PicFlip{1}, extras)[0];
  };
  const double stress_first = error({Order::usf});

  EXPECT_LT(error({Order::usl}), stress_first);
  EXPECT_LT(error({Order::usf, {}, 2}), stress_first);
}

TEST(TurningRing, DoesNotConvergeWithTheHoopStressTurnedRound) {
  // The radial force is then wrong by 2 mu gamma^2/(rho r), which no mesh knows of.
  const auto right = manufactured_errors<2>(TurningRing{0.3}, 16, Quadratic{}, Apic{});
  const auto wrong = manufactured_errors<2>(TurningRing{0.3, 1}, 16, Quadratic{}, Apic{});

  EXPECT_LT(std::log2(wrong[0] / wrong[1]), 0.5);
  EXPECT_GT(wrong[1], 4 * right[1]);
}

TEST(AxisAlignedSwing, StopsConvergingUnderLinearShapesWherePointsCrossCells) {
  // Points stand a quarter of a cell from its sides and move by up to A: on 8 and 16 cells none crosses one,
  // on 32 some do, as 1/(4 A) = 25.
  for (const AnyTransfer& rule : {AnyTransfer{Apic{}}, AnyTransfer{PicFlip{1}}}) {
    const auto errors = manufactured_errors<3>(AxisAlignedSwing{0.01}, 8, Linear{}, rule);

    EXPECT_LT(errors[1], errors[0]);
    EXPECT_GT(errors[2], 1.5 * errors[1]);
    // The remedy: the same motion under quadratic shapes.
    EXPECT_LT(manufactured_errors<1>(AxisAlignedSwing{0.01}, 32, Quadratic{}, rule)[0], errors[2] / 5);
  }
}

TEST(AxisAlignedSwing, KeepsTheErrorOfTheStrainUnderLinearShapesThatNoPointLeaves) {
  // What a cell holds is then 1 + u' of its volume, so that its stress counts 1 + u' times: relative to the
  // displacement an error of the size of the strain, 2 pi A, that no mesh removes. On 32 cells the error of
  // second order, (2 pi/32)^2 A and less, has come down to it.
  constexpr double amplitude = 0.002;
  const auto errors = manufactured_errors<2>(AxisAlignedSwing{amplitude}, 16, Linear{}, Apic{});

  EXPECT_LT(std::log2(errors[0] / errors[1]), 1.5);
  EXPECT_NEAR(errors[1], 2 * std::numbers::pi * amplitude * amplitude, errors[0] / 4);
}

}  // namespace
}  // namespace scree::mpm
