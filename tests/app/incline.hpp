#pragma once

#include "scenes.hpp"
#include "scree/run/simulation.hpp"
#include "scree/scene/material_columns.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace scree::app::testing {

/// Cell averages over the depth at one time.
struct Profile {
  std::vector<double> size;      ///< s_a [mm]
  std::vector<double> velocity;  ///< along the slope [m/s]
};

/// The reference of one variant of the paper's flow: time [s] to profile.
[[nodiscard]] inline std::map<double, Profile> reference(char variant) {
  std::ifstream file{SCREE_TEST_SCENES "/../plot/reference_incline.csv"};
  std::map<double, Profile> profiles;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] != variant || line[1] != ',') continue;
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream fields{line.substr(1)};
    double time = 0;
    double y = 0;
    double size = 0;
    double velocity = 0;
    fields >> time >> y >> size >> velocity;
    profiles[time].size.push_back(size);
    profiles[time].velocity.push_back(velocity);
  }
  if (profiles.empty()) throw std::runtime_error{"no reference profiles for this variant"};
  return profiles;
}

/// Averages over equal parts of the depth of 1 m, by mass.
template <int D>
[[nodiscard]] Profile profile_of(const Simulation<D, 2>& simulation, std::size_t num_parts) {
  constexpr int normal = D == 1 ? 0 : 1;
  constexpr int along = D == 1 ? 1 : 0;
  const auto& particles = simulation.state.particles;
  const double* size = particles.column(particles.find_column(grain_size_column, "the test")).component(0);
  Profile profile{std::vector<double>(num_parts, 0.0), std::vector<double>(num_parts, 0.0)};
  std::vector<double> masses(num_parts, 0.0);
  for (Index p = 0; p < particles.size(); ++p) {
    const double place = particles.position.component(normal)[p] * static_cast<double>(num_parts);
    const auto part = std::min(static_cast<std::size_t>(place), num_parts - 1);
    const double mass = particles.mass.component(0)[p];
    masses[part] += mass;
    profile.size[part] += mass * size[p] * 1e3;
    profile.velocity[part] += mass * particles.velocity.component(along)[p];
  }
  for (std::size_t i = 0; i < num_parts; ++i) {
    profile.size[i] /= masses[i];
    profile.velocity[i] /= masses[i];
  }
  return profile;
}

/// How far a run is from the reference at the times of the table.
struct InclineErrors {
  std::vector<double> size;  ///< mean |s_a - reference| at each time [mm]
  double velocity = 0;       ///< largest |u - reference| over the reference's surface speed at 10 s [-]

  [[nodiscard]] double largest_size() const { return *std::max_element(size.begin(), size.end()); }
  [[nodiscard]] double mean_size() const {
    double sum = 0;
    for (const double error : size) sum += error;
    return sum / static_cast<double>(size.size());
  }
};

/// Runs a variant to the end and compares; leaves the simulation there.
template <int D>
[[nodiscard]] InclineErrors errors_of(Simulation<D, 2>& simulation, char variant) {
  const auto profiles = reference(variant);
  const double surface_speed = profiles.rbegin()->second.velocity.back();
  InclineErrors errors;
  for (const auto& [time, expected] : profiles) {
    advance_to(time, simulation);
    const Profile profile = profile_of(simulation, expected.size.size());
    double difference = 0;
    for (std::size_t i = 0; i < expected.size.size(); ++i) {
      difference += std::abs(profile.size[i] - expected.size[i]);
      errors.velocity =
          std::max(errors.velocity, std::abs(profile.velocity[i] - expected.velocity[i]) / surface_speed);
    }
    errors.size.push_back(difference / static_cast<double>(expected.size.size()));
  }
  return errors;
}

/// The name of the column scene of a variant.
[[nodiscard]] inline std::string column_scene(char variant) {
  if (variant == 'B') return "inclined_plane_column";
  return std::string{"inclined_plane_column_"} + static_cast<char>(variant - 'A' + 'a');
}

}  // namespace scree::app::testing
