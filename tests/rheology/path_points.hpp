#pragma once

#include <scree/rheology/path/drive.hpp>
#include <scree/rheology/path/paths.hpp>

#include <array>
#include <string>
#include <vector>

namespace scree::rheology {

/// What a stress of a path may be off by [Pa]: the tolerance it was asked for with, on the largest stress,
/// and the rounding of strains met by the modulus rho c^2.
[[nodiscard]] inline double tolerance_of_stress(const PathPoint& point, double largest_stress) {
  const double speed = point.stiffness({Tensor<double>{}, point.now.density}).wave_speed;
  return PathOptions{}.tolerance * largest_stress + 100 * round_off * point.now.density * speed * speed;
}

/// Leads a point along one stage.
inline std::vector<PathRecord> drive(PathPoint& point, const Controls& controls, double duration,
                                     Index num_steps) {
  return drive(point, std::array{Stage{"the test", duration, num_steps, controls}});
}

/// What a call throws, or "no error".
template <class Exception, class Call>
[[nodiscard]] std::string message_of(Call&& call) {
  try {
    call();
  } catch (const Exception& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace scree::rheology
