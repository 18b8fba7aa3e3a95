// Paths on which the grains rest, flow and rest again, with exact solutions: no spin, and a pressure that is
// given.

#include "samples.hpp"

#include <scree/rheology/laws/granular_elastoviscoplastic.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace scree::rheology {
namespace {

using Grains = GranularElastoviscoplastic;
constexpr Grains law = typical<Grains>();
constexpr double size = 1e-3;                                         // [m]
constexpr double p = 1000;                                            // [Pa]
constexpr double pressed = law.density * (1 + p / law.bulk_modulus);  // [kg/m^3]
constexpr double S_0 = law.mu_s * p;
constexpr double S_2 = law.mu_2 * p;

/// Pure shear at the rate gdot [1/s]: stress does not turn.
[[nodiscard]] Tensor<double> pure_shear(double rate) {
  return diagonal(rate / 2, -rate / 2, 0);
}

[[nodiscard]] double shear_stress(const Point<Grains>& point) {
  return std::sqrt(squared_norm(point.state) / 2);
}

/// G times the plastic rate of I = I_0, over p [1/s].
[[nodiscard]] double return_rate() {
  return law.shear_modulus * law.I_0 * std::sqrt(p / law.grain_density) / size;
}

/// The stress in [low, high] at which a time that rises or falls with it is `time`, by bisection.
[[nodiscard]] double stress_at(double time, double low, double high,
                               const std::function<double(double)>& time_of) {
  const bool rises = time_of(low) < time_of(high);
  for (double middle = (low + high) / 2; low < middle && middle < high; middle = (low + high) / 2) {
    ((time_of(middle) < time) == rises ? low : high) = middle;
  }
  return high;
}

/// Errors over `time` in `num_steps` of a rate that is held, from a shear stress: the last one, and the
/// largest.
struct Errors {
  double last;
  double largest;
};
[[nodiscard]] Errors errors(double rate, double start, double time, int num_steps,
                            const std::function<double(double)>& exact) {
  Point<Grains> point{law};
  point.state.xx = start;
  point.state.yy = -start;
  Errors result{};
  for (int n = 1; n <= num_steps; ++n) {
    point.step(pure_shear(rate), pressed, time / num_steps, size);
    result.last = shear_stress(point) - exact(time * n / num_steps);
    result.largest = std::max(result.largest, std::abs(result.last));
  }
  return result;
}

/// Held at a strain, stress above yield relaxes down to mu_s p and never below, in a time of
/// (S_2 - S_0)/(G gdot_0). Backward Euler of an equation that only falls, and ever more slowly, lags behind,
/// by at most half a step times the first rate.
TEST(GranularElastoviscoplastic, RelaxesToItsStaticFriction) {  // Eq. (R36)
  const double start = (S_0 + S_2) / 2;
  const double k = return_rate();
  const auto exact = [&](double t) {
    return stress_at(k * t, S_0 * (1 + 1e-12), start, [&](double tau) {
      return tau - start + (S_2 - S_0) * std::log((start - S_0) / (tau - S_0));
    });
  };
  const double time = 3 * (S_2 - S_0) / k;
  const double first_rate = k * (start - S_0) / (S_2 - start);

  const Errors coarse = errors(0, start, time, 200, exact);
  const Errors fine = errors(0, start, time, 400, exact);

  EXPECT_GT(coarse.last, 0);
  EXPECT_LE(coarse.largest, time / 200 / 2 * first_rate);
  EXPECT_NEAR(std::log2(coarse.last / fine.last), 1, 0.05);  // the next term is a share of k dt/(S_2 - S_0)
  Point<Grains> point{law};
  point.state.xx = start;
  point.state.yy = -start;
  for (int n = 0; n < 1000; ++n) point.step({}, pressed, 10 * time, size);
  const double rounding = law.mu_s * 10 * round_off * law.bulk_modulus;  // p is a difference of parts of K
  EXPECT_NEAR(shear_stress(point), S_0, rounding);
}

/// From rest the stress rises as G gdot t to mu_s p, exactly, and from there by the flow rule to mu(I) p.
TEST(GranularElastoviscoplastic, StartsToFlowByItsExactSolution) {  // Eq. (R37)
  const double k = return_rate();
  for (const double q : {0.1, 1.0}) {  // I/I_0
    const double rate = q * k / law.shear_modulus;
    const double yield_time = S_0 / (law.shear_modulus * rate);
    const double plateau = (S_0 + q * S_2) / (1 + q);
    const auto exact = [&](double t) {
      if (t <= yield_time) return law.shear_modulus * rate * t;
      const double end = plateau - 1e-9 * (plateau - S_0);
      return stress_at(k * (1 + q) * (t - yield_time), S_0, end, [&](double tau) {
        return tau - S_0 + (S_2 - plateau) * std::log((plateau - S_0) / (plateau - tau));
      });
    };

    // 300 steps, 100 of them elastic
    const double time = 3 * yield_time;
    const Errors coarse = errors(rate, 0, time, 300, exact);
    const Errors fine = errors(rate, 0, time, 600, exact);

    EXPECT_LE(coarse.largest, time / 300 / 2 * law.shear_modulus * rate) << q;  // as in relaxation
    EXPECT_NEAR(fine.largest / coarse.largest, 0.5, 0.05);  // first order; the next term is a tenth at most
    Point<Grains> elastic{law};
    for (int n = 0; n < 100; ++n) elastic.step(pure_shear(rate), pressed, yield_time / 100, size);
    EXPECT_NEAR(shear_stress(elastic), S_0, 100 * 10 * round_off * S_0);
  }
}

/// What friction is above mu_s in a step of `Sample` by a strain, one of a second, for grains of 1 mm: the
/// plastic rate is at most that of the strain, 2/sqrt(3) of it, and of the stress, mu_s K/G of it.
[[nodiscard]] double above_static_friction(double strain, double pressure) {
  const double rate = (2 / std::sqrt(3.0) + law.mu_s * law.bulk_modulus / law.shear_modulus) * strain;
  return (law.mu_2 - law.mu_s) * rate * size * std::sqrt(law.grain_density / pressure) / law.I_0;
}

/// Compressed between walls it bears sideways what its elasticity asks for, K0 = (K - 2/3 G)/(K + 4/3 G),
/// unless that is more shear than slow friction bears, from G/K = sqrt(3)/2 mu_s on: then
/// K0 = (1 - mu_s/sqrt(3))/(1 + 2 mu_s/sqrt(3)).
TEST(GranularElastoviscoplastic, HasTheK0OfElasticityOrOfFriction) {  // Eq. (R38)
  const double root = std::sqrt(3.0);
  for (const double part : {0.5, 0.99, 1.01, 2.0}) {  // of the shear modulus at which it yields
    Grains grains = law;
    grains.shear_modulus = part * root / 2 * law.mu_s * law.bulk_modulus;
    Sample<Grains> sample{{grains}};
    const double strain = 1e-4;

    for (int n = 0; n < 100; ++n) sample.step(0, -strain / 100, 0);

    const double mu = std::min(part, 1.0) * law.mu_s;
    const double exact = (1 - mu / root) / (1 + 2 * mu / root);
    EXPECT_NEAR(sample.stress(0) / sample.stress(1), exact, strain) << part;  // p is K (e^strain - 1)
    EXPECT_NEAR(sample.pressure(), law.bulk_modulus * std::expm1(strain), 10 * round_off * law.bulk_modulus);
  }
}

/// Unloaded from there by the strain 2 mu_s p/(2 G/sqrt(3) + mu_s K) it yields the other way, and pushes
/// sideways more than down, by K0 = (1 + mu_s/sqrt(3))/(1 - 2 mu_s/sqrt(3)): overconsolidated ground.
TEST(GranularElastoviscoplastic, YieldsTheOtherWayWhenUnloaded) {  // Eq. (R38)
  const double root = std::sqrt(3.0);
  const double shear = 2 * law.shear_modulus / root;  // dtau per strain [Pa]
  const double strain = 1e-4;
  Sample<Grains> sample{{law}};
  const auto compress = [&](double by, int num_steps) {
    for (int n = 0; n < num_steps; ++n) sample.step(0, -by / num_steps, 0);
  };
  const auto friction = [&] {  // positive while it presses down more than sideways
    return (sample.stress(0) - sample.stress(1)) / root / sample.pressure();
  };
  compress(strain, 100);
  EXPECT_NEAR(friction(), law.mu_s, above_static_friction(strain / 100, sample.pressure()));

  const double turn = 2 * law.mu_s * sample.pressure() / (shear + law.mu_s * law.bulk_modulus);
  compress(-turn / 2, 50);  // elastic: p falls by K a strain, tau by `shear`, up to the strain itself
  EXPECT_NEAR(friction(), law.mu_s * law.mu_s * law.bulk_modulus / shear, 4 * strain);
  compress(-0.49 * turn, 49);
  EXPECT_GT(friction(), -0.99 * law.mu_s);
  compress(-0.09 * turn, 9);

  const double exact = (1 + law.mu_s / root) / (1 - 2 * law.mu_s / root);  // 2.18
  const double slope = (1 / root + 2 / root * exact) / (1 - 2 * law.mu_s / root);
  EXPECT_NEAR(sample.stress(0) / sample.stress(1), exact,
              slope * above_static_friction(turn / 100, sample.pressure()) * (1 + strain));
}

}  // namespace
}  // namespace scree::rheology
