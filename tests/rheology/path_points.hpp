#pragma once

#include <scree/rheology/path/drive.hpp>
#include <scree/rheology/path/paths.hpp>

#include <array>
#include <ostream>
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

/// A motion imposed component by component.
[[nodiscard]] inline Controls by_strain(const Tensor<double>& velocity_gradient) {
  Controls controls;
  for (std::size_t k = 0; k < symmetric_components.size(); ++k) {
    const std::size_t i = symmetric_components[k].row;
    const std::size_t j = symmetric_components[k].column;
    controls.on[k] = strain_rate((velocity_gradient(i, j) + velocity_gradient(j, i)) / 2);
    if (k < first_shear) continue;
    controls.spin[k - first_shear] = (velocity_gradient(i, j) - velocity_gradient(j, i)) / 2;
  }
  return controls;
}

/// How a test names a path.
inline void PrintTo(const NamedPath& path, std::ostream* stream) {
  *stream << path.name;
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
