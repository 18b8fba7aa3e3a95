#include <scree/grainsize/distribution.hpp>
#include <scree/grainsize/segregation_law.hpp>
#include <scree/grainsize/well_posedness.hpp>

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace scree::grainsize {
namespace {

constexpr int N = 5;
using State = PointSegregation<N>::State;
const Vector<1> upward = Vector<1>::Ones();

constexpr State inverse_sizes{1 / 0.2, 1 / 0.4, 1 / 0.6, 1 / 0.8, 1 / 1.0};

PointSegregation<N> law(double driver) {
  return {&inverse_sizes, driver, 0};
}

/// Reproducible mixtures, with classes missing from some.
std::vector<State> mixtures() {
  std::mt19937 random{20240501};
  std::exponential_distribution<double> draw;
  std::vector<State> states(200);
  for (std::size_t i = 0; i < states.size(); ++i) {
    for (double& phi : states[i]) phi = draw(random);
    if (i % 4 == 0) states[i][i / 4 % N] = 0;
    const double sum = std::accumulate(states[i].begin(), states[i].end(), 0.0);
    for (double& phi : states[i]) phi /= sum;
  }
  return states;
}

State pure(std::size_t k) {
  State phi{};
  phi[k] = 1;
  return phi;
}

TEST(SegregationLaw, FluxesAddToZero) {  // Eq. (G3) with the harmonic mean
  for (const State& phi : mixtures()) {
    const State flux = law(2).flux(phi, upward);

    const double sum = std::accumulate(flux.begin(), flux.end(), 0.0);
    // |F_k| <= |B| a/|B| <= 8 m/s here; about ten operations each on five of them.
    EXPECT_LE(std::abs(sum), 50 * 8 * round_off);
  }
}

TEST(SegregationLaw, ArithmeticMeanWouldMoveTheBulk) {  // the failure that the harmonic mean avoids
  const State phi{0.2, 0.2, 0.2, 0.2, 0.2};
  const double s_a = 0.6;

  double sum = 0;
  for (std::size_t k = 0; k < N; ++k) sum += phi[k] * (1 - s_a * inverse_sizes[k]);

  EXPECT_NEAR(sum, 1 - 0.6 * 0.2 * (5 + 2.5 + 1 / 0.6 + 1.25 + 1), 16 * round_off);
  EXPECT_LT(sum, -0.3);
}

TEST(SegregationLaw, OneSizeDoesNotSegregate) {
  for (std::size_t k = 0; k < N; ++k) {
    for (const double component : law(3).flux(pure(k), upward)) EXPECT_EQ(component, 0);
  }
}

TEST(SegregationLaw, LoneFineGrainMovesAsManyTimesFasterAsItIsFiner) {
  const double trace = 1e-9;
  const std::array<double, 2> inverse{1 / 0.5e-3, 1 / 1.5e-3};  // size ratio 3
  const PointSegregation<2> two{&inverse, 0.1, 0};

  const double fine = two.flux(std::array{trace, 1 - trace}, upward)[0] / trace;
  const double coarse = two.flux(std::array{1 - trace, trace}, upward)[1] / trace;

  EXPECT_NEAR(fine, -0.1 * 2, 0.1 * 7 * trace);  // -q B (1 - r phi) to first order, q r = 6
  EXPECT_NEAR(-fine / coarse, 3, 3 * 8 * trace);
}

TEST(SegregationLaw, OfTwoSizesIsTheClosedForm) {  // Eq. (G9)
  const std::array<double, 2> inverse{1 / 0.5e-3, 1 / 1e-3};
  const PointSegregation<2> two{&inverse, 1, 0};

  for (const double phi : {0.0, 0.1, 0.5, 0.9, 1.0}) {
    const auto flux = two.flux(std::array{phi, 1 - phi}, upward);
    EXPECT_NEAR(flux[0], -bidisperse_flux(phi, 2), 16 * round_off);  // some ten operations on numbers up to 1
    EXPECT_NEAR(flux[1], bidisperse_flux(phi, 2), 16 * round_off);
  }
}

TEST(SegregationLaw, SpeedBoundsEveryCharacteristic) {  // Eq. (G10), by the numerical Jacobian
  constexpr double step = 1e-6;
  for (const State& phi : mixtures()) {
    Eigen::Matrix<double, N, N> jacobian;
    for (std::size_t j = 0; j < N; ++j) {
      State above = phi;
      State below = phi;
      above[j] += step;
      below[j] -= step;
      const State flux_above = law(-2).flux(above, upward);
      const State flux_below = law(-2).flux(below, upward);
      for (std::size_t k = 0; k < N; ++k) {
        jacobian(static_cast<int>(k), static_cast<int>(j)) = (flux_above[k] - flux_below[k]) / (2 * step);
      }
    }
    const auto characteristics = jacobian.eigenvalues();

    const double speed = law(-2).max_speed(phi, phi, upward);

    // Differences are good to |F| round_off/step + step^2; a square root of that where eigenvalues meet.
    const double tolerance = 10 * std::sqrt(8 * round_off / step);
    for (const auto& lambda : characteristics) {
      EXPECT_LE(std::abs(lambda.real()), speed + tolerance);
      EXPECT_LE(std::abs(lambda.imag()), tolerance);  // hyperbolic
    }
  }
}

TEST(SegregationLaw, SpeedBoundsTheVelocityOfEveryClass) {
  for (const State& phi : mixtures()) {
    const double s_h = harmonic_mean(std::array{0.2, 0.4, 0.6, 0.8, 1.0}, phi);
    const double speed = law(1).max_speed(phi, phi, upward);

    for (const double h : inverse_sizes) EXPECT_LE(std::abs(1 - s_h * h), speed * (1 + 16 * round_off));
  }
}

TEST(SegregationLaw, SpeedBoundsTheWholeLineBetweenTwoStates) {
  const auto states = mixtures();
  for (std::size_t i = 0; i + 1 < states.size(); ++i) {
    const double speed = law(1).max_speed(states[i], states[i + 1], upward);
    for (const double part : {0.2, 0.5, 0.8}) {
      State between;
      for (std::size_t k = 0; k < N; ++k) between[k] = std::lerp(states[i][k], states[i + 1][k], part);
      EXPECT_LE(law(1).max_speed(between, between, upward), speed * (1 + 16 * round_off));
    }
  }
}

TEST(SegregationLaw, ClassVelocityIsNoBound) {  // the trap: at phi = 1 the fines stand, their wave does not
  const std::array<double, 2> inverse{1 / 0.5e-3, 1 / 1e-3};
  const PointSegregation<2> two{&inverse, 1, 0};
  const double phi = 1;
  const double s_h = 0.5e-3;
  const double velocity_of_fines = 1 - s_h * inverse[0];

  const double characteristic =
      (two.flux(std::array{phi, 0.0}, upward)[0] - two.flux(std::array{phi - 1e-7, 1e-7}, upward)[0]) / 1e-7;

  EXPECT_EQ(velocity_of_fines, 0);
  EXPECT_NEAR(characteristic, 0.5, 1e-6);  // B q/r; the flux is smooth with a second derivative below 1
  EXPECT_GE(two.max_speed(std::array{phi, 0.0}, std::array{phi, 0.0}, upward), 0.5 * (1 - 4 * round_off));
}

TEST(SegregationLaw, ClassesWithoutVolumeOfTheLargestSizeChangeNothing) {
  const std::array<double, 2> two_sizes{1 / 0.5, 1 / 1.0};
  const std::array<double, 4> four_sizes{1 / 0.5, 1 / 1.0, 1 / 1.0, 1 / 1.0};
  const PointSegregation<2> two{&two_sizes, 0.7, 0};
  const PointSegregation<4> four{&four_sizes, 0.7, 0};
  const std::array<double, 2> phi{0.3, 0.7};
  const std::array<double, 4> padded{0.3, 0.7, 0, 0};

  const auto flux = two.flux(phi, upward);
  const auto flux_padded = four.flux(padded, upward);

  EXPECT_EQ(flux_padded, (std::array{flux[0], flux[1], 0.0, 0.0}));
  EXPECT_EQ(four.max_speed(padded, padded, upward), two.max_speed(phi, phi, upward));
}

}  // namespace
}  // namespace scree::grainsize
