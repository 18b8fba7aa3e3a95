#include "bodies.hpp"

#include <scree/rheology_stiff/rkl2.hpp>

#include <gtest/gtest.h>

namespace scree::rheology {
namespace {

/// What one step makes of u = 1 where u' = -u.
double amplification(double step, int stages) {
  Rkl2 method{1};
  std::vector<double> u{1};
  method.advance(u, step, stages, [](auto v, auto rate) { rate[0] = -v[0]; });
  return u[0];
}

/// Longest stable step of s stages for u' = -u, whose explicit one is 2 s.  Eq. (R142)
double limit(int stages) {
  return 2 * (stages * stages + stages - 2) / 4.0;
}

/// P_s, by its recursion.
double legendre(int s, double x) {
  double before = 1;
  double now = x;
  for (int j = 2; j <= s; ++j) {
    const double next = ((2 * j - 1) * x * now - (j - 1) * before) / j;
    before = now;
    now = next;
  }
  return now;
}

TEST(Rkl2, IsALegendrePolynomial) {  // Eq. (R141)
  for (const int s : {2, 3, 4, 7, 20, 101}) {
    const double b = (s * s + s - 2.0) / (2.0 * s * (s + 1));
    for (const double share : {0.01, 0.3, 0.77, 1.0}) {
      const double z = share * limit(s);
      const double expected = 1 - b + b * legendre(s, 1 - 4 * z / (s * s + s - 2));
      // s stages, the rounding of each passed on undamped: s^2 at most.
      EXPECT_NEAR(amplification(z, s), expected, 8 * s * s * round_off) << s << ' ' << share;
    }
  }
}

TEST(Rkl2, IsStableUpToItsLimitAndNotAboveIt) {
  for (const int s : {2, 4, 10, 30}) {  // of an even number the limit is sharp
    for (int n = 1; n <= 1000; ++n) {
      EXPECT_LE(std::abs(amplification(0.999 * n / 1000 * limit(s), s)), 1) << s << ' ' << n;
    }
    EXPECT_GT(amplification(1.001 * limit(s), s), 1) << s;
  }
  for (const int s : {3, 5, 11, 31}) {  // of an odd one there is damping at it: 1 - 2 b, Eq. (R143)
    const double b = (s * s + s - 2.0) / (2.0 * s * (s + 1));
    EXPECT_NEAR(amplification(limit(s), s), 1 - 2 * b, 8 * s * s * round_off);
    for (int n = 1; n <= 1000; ++n) {
      EXPECT_LE(std::abs(amplification(n / 1000.0 * limit(s), s)), 1) << s << ' ' << n;
    }
    // P_s(x) = -3 for the amplification 1 - 4 b, -1 or less, near x = -1 - 2/P_s'(1) = -1 - 4/(s^2 + s).
    EXPECT_LT(amplification(limit(s) * (1 + 4.0 / (s * s + s)), s), -1) << s;
  }
}

TEST(Rkl2, IsOfSecondOrder) {  // u' = -u^2
  const auto error = [](int num_steps, int stages) {
    Rkl2 method{1};
    std::vector<double> u{1};
    for (int n = 0; n < num_steps; ++n) {
      method.advance(u, 1.0 / num_steps, stages, [](auto v, auto rate) { rate[0] = -v[0] * v[0]; });
    }
    return std::abs(u[0] - 0.5);
  };
  for (const int s : {3, 5, 9}) {
    // What is off by third order is a share of about one step, 1/40.
    EXPECT_NEAR(std::log2(error(40, s) / error(80, s)), 2, 0.05) << s;
  }
}

TEST(Rkl2, TakesAsManyStagesAsTheStepNeeds) {  // Eq. (R142)
  EXPECT_EQ(rkl2_stages(0, 1), 3);
  EXPECT_EQ(rkl2_stages(2.5, 1), 3);       // (9 + 3 - 2)/4
  EXPECT_EQ(rkl2_stages(2.500001, 1), 5);  // 4 would do, but damps nothing
  EXPECT_EQ(rkl2_stages(7, 1), 5);
  EXPECT_EQ(rkl2_stages(7.000001, 1), 7);
  EXPECT_EQ(rkl2_stages(250749.5, 1), 1001);
}

TEST(Rkl2, DampsTheShortestWaveOfAViscousLayer) {
  const auto grid = test::cube<1>(32, true);
  const auto mass = test::full(grid, 1);
  const ViscousOperator<1, 2> viscous{grid};
  const std::vector<double> weights(32, 1.0 / 32);
  std::vector<double> v;
  for (int i = 0; i < 32; ++i) v.insert(v.end(), {0.0, i % 2 == 0 ? 1.0 : -1.0});
  const double explicit_step = 2 / viscous.largest_rate(mass, weights);
  const double step = 100 * explicit_step;
  const int s = rkl2_stages(step, explicit_step);

  Rkl2{v.size()}.advance(v, step, s, [&](auto u, auto rate) {
    viscous.apply({}, weights, u, rate);
    for (std::size_t i = 0; i < rate.size(); ++i) rate[i] /= -mass[i / 2];
  });

  const double z = step * 4 * 32 * 32;  // of shear, 3/4 of the largest rate
  const double b = (s * s + s - 2.0) / (2.0 * s * (s + 1));
  const double expected = 1 - b + b * legendre(s, 1 - 4 * z / (s * s + s - 2));
  EXPECT_LT(std::abs(expected), 0.7);
  EXPECT_NEAR(v[1], expected, 100 * s * s * round_off);
}

TEST(Rkl2, RefusesWhatDoesNotFit) {
  const auto refusal = [](double step, double explicit_step) {
    return test::message_of<InputError>([&] { static_cast<void>(rkl2_stages(step, explicit_step)); });
  };
  EXPECT_EQ(refusal(-1, 1), "rkl2_stages: the step is -1 s: must be zero or positive, and finite");
  EXPECT_EQ(refusal(1, 0), "rkl2_stages: the explicit step is 0 s: must be positive");
  EXPECT_EQ(refusal(1, std::nan("")), "rkl2_stages: the explicit step is nan s: must be positive");
  EXPECT_EQ(refusal(1e6, 1), "rkl2_stages: a step of 1e+06 s takes 1999.5 stages: must be 1001 or fewer");
  Rkl2 method{2};
  std::vector<double> u(3);
  const Rkl2::Rate none = [](auto /*v*/, auto /*rate*/) {};
  EXPECT_EQ(test::message_of<InputError>([&] { method.advance(u, 1, 3, none); }),
            "Rkl2: 3 values: must be 2");
  u.resize(2);
  EXPECT_EQ(test::message_of<InputError>([&] { method.advance(u, 1, 1, none); }),
            "Rkl2: 1 stages: must be 2 or more");
}

}  // namespace
}  // namespace scree::rheology
