#include "scree/run/run.hpp"
#include "scree/scene/axes.hpp"

#include <scree/io/frame_reader.hpp>

#include <fmt/format.h>

#include <cmath>

namespace scree::app {

namespace {

/// Sums over the points of one part of the depth, weighted by mass.
struct Part {
  double mass = 0;
  double momentum = 0;
  std::vector<double> class_masses;
};

[[nodiscard]] std::string csv_of(const std::vector<Part>& parts, double low, double height,
                                 std::span<const double> diameters) {
  std::string csv = "y,velocity,mean_grain_size";
  for (std::size_t k = 1; k <= diameters.size(); ++k) csv += fmt::format(",phi_{}", k);
  csv += "\n";
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Part& part = parts[i];
    if (!(part.mass > 0)) continue;
    double size = 0;
    for (std::size_t k = 0; k < diameters.size(); ++k)
      size += diameters[k] * part.class_masses[k] / part.mass;
    csv += fmt::format("{:.9g},{:.9g},{:.9g}", low + (static_cast<double>(i) + 0.5) * height,
                       part.momentum / part.mass, size);
    for (const double mass : part.class_masses) csv += fmt::format(",{:.9g}", mass / part.mass);
    csv += "\n";
  }
  return csv;
}

[[nodiscard]] int filled_cells(const Scene& scene, double depth) {
  const auto normal = static_cast<std::size_t>(normal_component(scene.mesh.dimensions));
  return static_cast<int>(
      std::lround(depth * static_cast<double>(scene.mesh.cells) / scene.mesh.size[normal]));
}

}  // namespace

std::string profile_csv(const std::filesystem::path& directory, std::optional<double> time,
                        std::optional<int> num_parts) {
  const Scene scene = read_scene(directory / "scene.toml", {}).scene;
  const io::FrameReader reader{directory};
  require(!reader.frames().empty(), directory.string() + ": holds no frame yet");
  const io::StoredFrame& frame = time ? reader.nearest(*time) : reader.frames().back();
  const auto normal = static_cast<std::size_t>(normal_component(scene.mesh.dimensions));
  const double low = scene.material.low[normal];
  const double depth = scene.material.high[normal] - low;
  const int count = num_parts.value_or(std::max(1, filled_cells(scene, depth)));
  require(count >= 1, "--cells must be at least 1");
  const std::size_t num_classes = scene.grains ? scene.grains->classes.size() : 0;

  constexpr std::size_t stored = 3;  // vectors are stored with the components x, y, z
  const auto position = reader.read(frame, "position");
  const auto velocity = reader.read(frame, "velocity");
  const auto mass = reader.read(frame, "mass");
  const auto fraction = num_classes > 0 ? reader.read(frame, "fraction") : std::vector<double>{};
  std::vector<Part> parts(static_cast<std::size_t>(count), Part{0, 0, std::vector<double>(num_classes, 0.0)});
  for (std::size_t p = 0; p < mass.size(); ++p) {
    const double place = std::floor((position[stored * p + 1] - low) / depth * count);
    if (!(0 <= place && place < count)) continue;
    Part& part = parts[static_cast<std::size_t>(place)];
    part.mass += mass[p];
    part.momentum += mass[p] * velocity[stored * p];
    for (std::size_t k = 0; k < num_classes; ++k)
      part.class_masses[k] += mass[p] * fraction[num_classes * p + k];
  }
  return csv_of(parts, low, depth / count,
                scene.grains ? scene.grains->classes.diameters() : std::span<const double>{});
}

}  // namespace scree::app
