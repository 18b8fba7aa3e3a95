#include "../cpu_time.hpp"
#include "problems.hpp"
#include "scree/run/simulation.hpp"

#include <scree/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace scree::charts {

namespace {

using Profile = std::vector<double>;  // mass between places that are 2.5 cm apart, over all mass [-]

[[nodiscard]] Profile profile_of(const mpm::Particles<2>& particles) {
  constexpr double width = 0.025;  // [m]
  Profile profile(32, 0.0);        // the scene is 0.8 m long
  double total = 0;
  for (Index p = 0; p < particles.size(); ++p) {
    const double mass = particles.mass.component(0)[p];
    const auto bin = static_cast<std::size_t>(std::max(0.0, particles.position.component(0)[p] / width));
    profile[std::min(bin, profile.size() - 1)] += mass;
    total += mass;
  }
  for (double& share : profile) share /= total;
  return profile;
}

struct Collapse {
  Profile profile{};
  double cpu_seconds = 0;  // of its steps
};

/// The column of the scene on a mesh of `cells` along its height, by a scheme.
[[nodiscard]] Collapse collapsed(const Scheme& scheme, Index cells) {
  app::Scene scene = app::read_scene(std::string{SCREE_SCENES} + "/granular_column_collapse.toml",
                                     {"mesh.cells=" + std::to_string(cells),
                                      "material.points_per_cell=" + std::to_string(scheme.points_per_axis)})
                         .scene;
  scene.shape = scheme.any_shape;
  scene.transfer = scheme.any_transfer;
  scene.order = scheme.order;
  scene.xpic_order = scheme.xpic_order;
  app::Simulation<2, 2> simulation{scene, {1}};
  const double start = cpu_seconds();
  while (!simulation.is_finished()) simulation.step();
  return {profile_of(simulation.state.particles), cpu_seconds() - start};
}

/// By quadratic splines with APIC on a mesh four times as fine as the finest, once.
[[nodiscard]] const Profile& reference(Index cells) {
  static const Profile profile =
      collapsed({.any_shape = mpm::Quadratic{}, .any_transfer = mpm::Apic{}}, cells).profile;
  return profile;
}

/// The share of the mass that lies elsewhere [-].
[[nodiscard]] double misplaced(const Profile& one, const Profile& other) {
  double sum = 0;
  for (std::size_t i = 0; i < one.size(); ++i) sum += std::abs(one[i] - other[i]);
  return sum / 2;
}

}  // namespace

std::vector<Run> collapse(const Scheme& scheme, bool is_quick) {
  std::vector<Run> runs;
  const Index finest = is_quick ? 6 : 24;
  for (Index cells = 6; cells <= finest; cells *= 2) {
    Run run{"collapse", scheme, cells};
    try {
      const Collapse one = collapsed(scheme, cells);
      run.cpu_seconds = one.cpu_seconds;
      run.error = misplaced(one.profile, reference(4 * finest));
    } catch (const RunError&) {  // points have left the mesh
      run.error = std::numeric_limits<double>::quiet_NaN();
    }
    runs.push_back(run);
  }
  return runs;
}

}  // namespace scree::charts
