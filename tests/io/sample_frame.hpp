#pragma once

#include <scree/io/frame.hpp>

#include <cstdint>
#include <vector>

namespace scree::io::test {

/// A column of points at heights y, flowing along x, with two size classes; every value follows from `step`.
class SampleFrame {
 public:
  SampleFrame(std::int64_t step, std::size_t num_points) : step_{step} {
    for (std::size_t point = 0; point < num_points; ++point) {
      const double value = static_cast<double>(step) + static_cast<double>(point) / 8;
      heights.push_back(value);
      velocities.insert(velocities.end(), {2 * value, -value});
      fractions.insert(fractions.end(), {0.25, 0.75});
      stresses.insert(stresses.end(), {1, 2, 3, 4, 5, 6, 7, 8, value});
      volumes.push_back(value);
    }
  }

  /// Refers to the vectors of this sample.
  [[nodiscard]] Frame frame() const {
    return {.time = 0.5 * static_cast<double>(step_),
            .step = step_,
            .position = {.quantity = {"position", "x", "m"},
                         .kind = ColumnKind::vector,
                         .values = heights,
                         .axes = {1, 0, 0}},
            .columns = {{.quantity = {"velocity", "v", "m/s"},
                         .kind = ColumnKind::vector,
                         .num_components = 2,
                         .values = velocities},
                        {.quantity = {"fraction", "phi", "-"},
                         .kind = ColumnKind::classes,
                         .num_components = 2,
                         .values = fractions},
                        {.quantity = {"stress", "sigma", "Pa"},
                         .kind = ColumnKind::tensor,
                         .num_components = 9,
                         .values = stresses},
                        {.quantity = {"volume", "V", "m^3"}, .values = volumes}}};
  }

  std::vector<double> heights, velocities, fractions, stresses, volumes;

 private:
  std::int64_t step_;
};

}  // namespace scree::io::test
