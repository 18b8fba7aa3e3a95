#include <scree/rheology/mohr_coulomb_return.hpp>

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace scree::rheology {
namespace {

using Vector3 = Vector<3>;
using Matrix3 = Matrix<3>;

/// A plane of the surface, n . sigma <= limit, with the direction m of its flow.
struct Plane {
  Vector3 n;
  Vector3 m;
  double limit;
};

/// A material by its nine planes, in no order of the stresses.
struct Soil {
  MohrCoulombFlow flow;
  double limit;
  double tension;

  [[nodiscard]] Matrix3 stiffness() const {
    return Matrix3::Constant(flow.lame_modulus) + 2 * flow.shear_modulus * Matrix3::Identity();
  }

  /// Six of friction, one for each ordered pair of axes, and three of tension.
  [[nodiscard]] std::vector<Plane> planes() const {
    std::vector<Plane> result;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        if (i == j) continue;
        Plane plane{Vector3::Zero(), Vector3::Zero(), limit};
        plane.n[i] = 1 + flow.sin_friction;
        plane.n[j] = -(1 - flow.sin_friction);
        plane.m[i] = 1 + flow.sin_dilatancy;
        plane.m[j] = -(1 - flow.sin_dilatancy);
        result.push_back(plane);
      }
      result.push_back({Vector3::Unit(i), Vector3::Unit(i), tension});
    }
    return result;
  }
};

[[nodiscard]] bool is_within(const std::vector<Plane>& planes, const Vector3& stress, double tolerance) {
  return std::ranges::all_of(
      planes, [&](const Plane& plane) { return plane.n.dot(stress) <= plane.limit + tolerance; });
}

/// Where the trial stress gets to if just these planes flow, and how much each does.
struct Candidate {
  Vector3 stress;
  Eigen::VectorXd multipliers;
  bool is_unique;  ///< false: the planes flow alike
};

[[nodiscard]] Candidate flowing(const std::vector<Plane>& active, const Matrix3& stiffness,
                                const Vector3& trial) {
  if (active.empty()) return {trial, {}, true};
  const auto size = static_cast<Eigen::Index>(active.size());
  Eigen::MatrixXd n(size, 3);
  Eigen::MatrixXd m(3, size);
  Eigen::VectorXd excess(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const Plane& plane = active[static_cast<std::size_t>(i)];
    n.row(i) = plane.n.transpose();
    m.col(i) = stiffness * plane.m;
    excess[i] = plane.n.dot(trial) - plane.limit;
  }
  const Eigen::FullPivLU<Eigen::MatrixXd> lu{n * m};
  if (!lu.isInvertible()) return {trial, excess, false};
  const Eigen::VectorXd multipliers = lu.solve(excess);
  return {trial - m * multipliers, multipliers, true};
}

/// Every choice of up to three of the planes.
[[nodiscard]] std::vector<std::vector<Plane>> choices(const std::vector<Plane>& planes) {
  std::vector<std::vector<Plane>> result{{}};
  for (const Plane& plane : planes) {
    const std::size_t size = result.size();
    for (std::size_t i = 0; i < size; ++i) {
      if (result[i].size() == 3) continue;
      result.push_back(result[i]);
      result.back().push_back(plane);
    }
  }
  return result;
}

/// Of all points where planes meet that lie within the surface, the one closest to the trial stress in
/// elastic energy.
[[nodiscard]] Vector3 closest_point(const Soil& soil, const Vector3& trial, double tolerance) {
  const auto planes = soil.planes();
  const Matrix3 stiffness = soil.stiffness();
  const Matrix3 compliance = stiffness.inverse();
  Vector3 closest = Vector3::Zero();
  double least = std::numeric_limits<double>::infinity();
  for (const auto& active : choices(planes)) {
    const Candidate candidate = flowing(active, stiffness, trial);
    if (!candidate.is_unique || !is_within(planes, candidate.stress, tolerance)) continue;
    const Vector3 away = trial - candidate.stress;
    const double energy = away.dot(compliance * away);
    if (energy >= least) continue;
    least = energy;
    closest = candidate.stress;
  }
  return closest;
}

/// All stresses within the surface that planes lead to which flow forwards: Koiter's rule.
[[nodiscard]] std::vector<Vector3> flows(const Soil& soil, const Vector3& trial, double tolerance) {
  const auto planes = soil.planes();
  std::vector<Vector3> result;
  for (const auto& active : choices(planes)) {
    const Candidate candidate = flowing(active, soil.stiffness(), trial);
    if (!candidate.is_unique || !is_within(planes, candidate.stress, tolerance)) continue;
    if (!active.empty() && candidate.multipliers.minCoeff() < 0) continue;
    result.push_back(candidate.stress);
  }
  return result;
}

/// Which stresses bear the whole tension, lie on the pyramid or coincide.
[[nodiscard]] std::string region(const Soil& soil, const Vector3& trial, const Vector3& stress,
                                 double tolerance) {
  if (stress == trial) return "elastic";
  std::string result;
  for (int i = 0; i < 3; ++i) result += std::abs(stress[i] - soil.tension) < tolerance ? 'T' : '.';
  const double strength = (1 + soil.flow.sin_friction) * stress[0] - (1 - soil.flow.sin_friction) * stress[2];
  if (std::abs(strength - soil.limit) < tolerance) result += " pyramid";
  if (std::abs(stress[0] - stress[1]) < tolerance) result += " 1=2";
  if (std::abs(stress[1] - stress[2]) < tolerance) result += " 2=3";
  return result;
}

const std::set<std::string> all_regions{"elastic",
                                        "... pyramid",
                                        "... pyramid 1=2",
                                        "... pyramid 2=3",
                                        "T..",
                                        "TT. 1=2",
                                        "TTT 1=2 2=3",
                                        "T.. pyramid",
                                        "T.. pyramid 2=3",
                                        "TT. pyramid 1=2",
                                        "TTT pyramid 1=2 2=3"};

/// Materials of every angle, stiff or soft in volume, cut in tension or not.
[[nodiscard]] Soil random_soil(std::mt19937& random, bool is_associated) {
  std::uniform_real_distribution<double> share{0, 1};
  Soil soil{};
  soil.flow.sin_friction = 0.1 + 0.8 * share(random);
  soil.flow.sin_dilatancy = soil.flow.sin_friction * (is_associated ? 1 : 0.1 + 0.9 * share(random));
  soil.flow.shear_modulus = 0.2 + share(random);
  soil.flow.lame_modulus = 3 * share(random) - 2 * soil.flow.shear_modulus / 3;
  soil.limit = share(random);
  const double apex = soil.limit / (2 * soil.flow.sin_friction);
  const double cut = share(random);
  soil.tension = cut < 0.5 ? apex : apex * share(random);
  return soil;
}

[[nodiscard]] Vector3 random_trial(std::mt19937& random, const Soil& soil) {
  std::normal_distribution<double> component{0, 2};
  const double pressure = component(random);
  Vector3 trial{component(random), component(random), component(random)};
  trial.array() += soil.tension - pressure;
  std::sort(trial.data(), trial.data() + 3, std::greater<>{});
  return trial;
}

[[nodiscard]] Vector3 returned(const Soil& soil, const Vector3& trial) {
  const auto stress =
      mohr_coulomb_return<double>({trial[0], trial[1], trial[2]}, soil.flow, soil.limit, soil.tension, 0);
  return {stress[0], stress[1], stress[2]};
}

constexpr int num_trials = 1000;
/// Numbers up to 10 after some 50 operations. What they are compared with solves three planes at once, which
/// friction and dilatancy of 0.1 and 0.01 at least tell apart: a matrix of condition 1e3.
constexpr double tolerance = 10 * 1e3 * 50 * round_off;

TEST(MohrCoulombReturn, FindsTheClosestPointIfAssociated) {  // Eqs. (R52) to (R56)
  std::mt19937 random{1};
  std::set<std::string> regions;
  for (int n = 0; n < num_trials; ++n) {
    const Soil soil = random_soil(random, true);
    const Vector3 trial = random_trial(random, soil);

    const Vector3 actual = returned(soil, trial);

    const Vector3 expected = closest_point(soil, trial, tolerance);
    EXPECT_LE((actual - expected).cwiseAbs().maxCoeff(), tolerance) << n << ": " << trial.transpose();
    regions.insert(region(soil, trial, actual, tolerance));
  }
  EXPECT_EQ(regions, all_regions);
}

TEST(MohrCoulombReturn, FlowsByTheRuleOfKoiter) {  // Eqs. (R52) to (R56)
  std::mt19937 random{2};
  std::set<std::string> regions;
  for (int n = 0; n < num_trials; ++n) {
    const Soil soil = random_soil(random, false);
    const Vector3 trial = random_trial(random, soil);

    const Vector3 actual = returned(soil, trial);

    const auto expected = flows(soil, trial, tolerance);
    EXPECT_FALSE(expected.empty()) << n << ": " << trial.transpose();
    for (const Vector3& stress : expected) {
      EXPECT_LE((actual - stress).cwiseAbs().maxCoeff(), tolerance) << n << ": " << trial.transpose();
    }
    regions.insert(region(soil, trial, actual, tolerance));
  }
  EXPECT_EQ(regions, all_regions);
}

}  // namespace
}  // namespace scree::rheology
