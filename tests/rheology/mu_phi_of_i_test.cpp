#include "compressible_growth.hpp"
#include "growth.hpp"
#include "points.hpp"

#include <scree/rheology/laws/mu_phi_of_i.hpp>

#include <gtest/gtest.h>

namespace scree::rheology {
namespace {

using Grains = MuPhiOfI;

/// Typical, without a floor that could be felt.
[[nodiscard]] Grains beads() {
  Grains law = typical<Grains>();
  law.shear_rate_floor = 1e-10;
  return law;
}

[[nodiscard]] double pressure_of(const Tensor<double>& sigma) {
  return -trace(sigma) / 3;
}

/// The equation of the step, from loose to dense, rest to rush, and over steps of any length.
TEST(MuPhiOfI, SolvesItsEquationOfAnyStep) {  // Eqs. (R78), (R79)
  const Grains law = beads();
  for (const double compression : {0.1, 0.9, 1.0, 1.001, 1.2}) {
    for (double rate = 1e-6; rate < 1e4; rate *= 100) {
      for (double dt = 1e-9; dt < 1e9; dt *= 100) {
        const auto response = law.update({simple_shear(rate), compression * law.density}, {1e-3}, {1.0}, dt);

        ASSERT_EQ(response.unsolved, 0) << compression << ' ' << rate << ' ' << dt;
        const double p = pressure_of(response.stress);
        const double strain = rate * dt / law.relaxation_strain;
        const double i = inertial_number(rate, 1e-3, p, law.grain_density);
        const double followed = (1 + strain * (1 + law.dilation * i)) / (1 + strain);
        // I goes with p to the power -1/2, and p is a square: roundings of the root, in terms of these sizes.
        const double tolerance = 1e-10 * (followed + 1 / compression);
        EXPECT_NEAR(response.state.unloaded_volume, followed, tolerance)
            << compression << ' ' << rate << ' ' << dt;
        EXPECT_NEAR(response.state.unloaded_volume * compression, 1 + p / law.bulk_modulus, 4 * round_off);
      }
    }
  }
}

/// Bagnold (1954): kept in a volume, sheared grains press with the square of the rate; phi(I) says how hard,
/// softened by p/K.
TEST(MuPhiOfI, PressesWithTheSquareOfTheRateInAGivenVolume) {  // Eq. (R80)
  Grains law = beads();
  law.bulk_modulus = 1e12;
  for (const double i : {0.03, 0.3, 3.0}) {
    const double density = law.density / (1 + law.dilation * i);
    for (const double rate : {1.0, 10.0}) {
      const auto sigma = law.update({simple_shear(rate), density}, {1e-3}, {1.0}, 1e15).stress;
      const double p = law.grain_density * std::pow(1e-3 * rate / i, 2);
      // The volume, less 1, is followed up to p/K and round-off, and p goes with its square.
      const double tolerance = 4 * (p / law.bulk_modulus + 10 * round_off) * (1 + 1 / (law.dilation * i));
      EXPECT_NEAR(pressure_of(sigma), p, (tolerance + 1e-12) * p) << i;
      const double friction = law.mu_s + (law.mu_2 - law.mu_s) * i / (law.I_0 + i);
      EXPECT_NEAR(sigma(0, 1) / pressure_of(sigma), friction, tolerance + 1e-12) << i;
    }
  }
}

/// At constant pressure the volume goes to that of phi(I) as exp(-gamma/gamma_r), from a denser or a looser
/// packing: the density that keeps the pressure is the exact one, and what the pressure is off by is of first
/// order in a step.
TEST(MuPhiOfI, FollowsThePackingOfItsFlowOverAStrain) {  // Eq. (R78)
  const Grains law = beads();
  const double p = 1000;
  const double rate = 30;
  const double i = inertial_number(rate, 1e-3, p, law.grain_density);
  const double steady = 1 + law.dilation * i;
  for (const double start : {0.95, 1.0, 1.3}) {
    const auto error = [&](int num_steps) {
      Point<Grains> point{law};
      point.state.unloaded_volume = start;
      double worst = 0;
      const double strain = 2 * law.relaxation_strain / num_steps;
      for (int n = 1; n <= num_steps; ++n) {
        const double volume = steady + (start - steady) * std::exp(-n * strain / law.relaxation_strain);
        point.step(simple_shear(rate), law.density * (1 + p / law.bulk_modulus) / volume, strain / rate);
        worst = std::max(worst, std::abs(point.state.unloaded_volume - volume));
      }
      return worst;
    };
    // The pressure answers with K: what the state is off by is about step (v - v_eq) p/K, and not more than a
    // step.
    EXPECT_LE(error(100), 2.0 / 100 * std::abs(start - steady)) << start;
    EXPECT_NEAR(error(200) / error(400), 2, 0.1) << start;
  }
}

/// At rest it is a packing as loose as it was left, elastic, without creep of its volume; pulled apart it
/// bears nothing, and bears again where it let go.
TEST(MuPhiOfI, RestsAsLooseAsItWasLeft) {  // Eq. (R79)
  const Grains law = beads();
  Point<Grains> point{law};
  point.state.unloaded_volume = 1.05;
  for (const double dt : {1e-3, 1e3, 1e9}) {
    point.step({}, 1.001 * law.density / 1.05, dt);
    EXPECT_NEAR(pressure_of(point.stress), 1e-3 * law.bulk_modulus, 10 * round_off * law.bulk_modulus);
    point.step({}, 0.9 * law.density / 1.05, dt);
    EXPECT_EQ(largest(point.stress), 0);
    EXPECT_NEAR(point.state.unloaded_volume, 1.05, 20 * round_off);
  }
}

/// Where it fails. If the packing follows at once (gamma_r = 0, the mu(I)-phi(I) law as it is written) the
/// pressure answers the shear rate alone, and disturbances grow as k^2 in flow of any rate unless friction
/// exceeds 6/7: the determinant of the resistance, mu (mu (8 - alpha^2)/3 - 2 alpha), at alpha = 1. This is
/// the bound of Heyman et al. (2017) for grains without bulk friction, 7 mu/2 > 3.
TEST(MuPhiOfI, IsIllPosedBelowAFrictionOfSixSeventhsIfItFollowsAtOnce) {  // Eq. (R80)
  for (const double friction : {0.4, 0.85, 0.865, 0.9}) {
    Grains law = beads();
    law.mu_s = friction;
    law.mu_2 = friction * (1 + 1e-9);
    law.bulk_modulus = 1e12;
    for (const double i : {0.03, 0.3, 3.0}) {
      const double density = law.density / (1 + law.dilation * i);
      double least = 1;
      for (int n = 0; n < 400; ++n) {
        const auto answer =
            answer_of(law, simple_shear(10), density, std::numbers::pi * n / 400, 1e15).by_velocity;
        least = std::min(least, answer.determinant() / answer.squaredNorm());
      }
      EXPECT_EQ(least > 0, friction > 6.0 / 7) << friction << ' ' << i;
    }
  }
}

/// Growth then quadruples as the wave is halved. Followed over a strain, the memory is frozen for the
/// shortest waves, and these are resisted in every direction: growth is bounded, if only by the stiffness of
/// the packing. `CompressibleMuOfI` needs no such help.
TEST(MuPhiOfI, ResistsTheShortestDisturbancesIfItFollowsOverAStrain) {
  const Grains law = beads();
  const double i = 0.3;
  const double density = law.density / (1 + law.dilation * i);
  const auto base = simple_shear(10);
  const double at_once = 1e9;  // [s], in which the volume has followed
  for (const double k : {1e5, 1e6}) {
    const double ratio =
        fastest_growth(law, base, density, 2 * k, at_once) / fastest_growth(law, base, density, k, at_once);
    EXPECT_NEAR(ratio, 4, 0.01) << k;  // sound is slower than eta k/rho by 1/70 and less, squared
  }
  Point<Grains> flowing{law};
  flowing.step(base, density, at_once);
  Grains frozen = law;
  frozen.relaxation_strain = 1e12;
  frozen.density = law.density / flowing.state.unloaded_volume;  // it begins at 1
  for (int n = 0; n < 400; ++n) {
    const auto answer = answer_of(frozen, base, density, std::numbers::pi * n / 400, 1e-9).by_velocity;
    EXPECT_GT(answer.determinant(), 0) << n;
    EXPECT_GT(answer.trace(), 0) << n;
  }
}

}  // namespace
}  // namespace scree::rheology
