#include "scree/scene/checkpoint_points.hpp"

#include "scree/scene/checkpoint_layout.hpp"
#include "scree/scene/traits.hpp"

#include <algorithm>
#include <sstream>
#include <string>

namespace scree::app {

namespace {

[[nodiscard]] std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream{text};
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace

io::Checkpoint open_checkpoint(const std::filesystem::path& path) {
  return io::read_checkpoint(path, checkpoint_version);
}

std::vector<std::size_t> heavy_points(const io::Checkpoint& checkpoint) {
  const std::string entry = entry_of("mass");
  const auto masses = checkpoint.doubles(entry, checkpoint.length(entry));
  std::vector<std::size_t> heavy;
  for (std::size_t p = 0; p < masses.size(); ++p) {
    if (masses[p] > 0) heavy.push_back(p);
  }
  return heavy;
}

std::vector<double> values_of(const io::Checkpoint& checkpoint, std::string_view column, int num_components,
                              const std::vector<std::size_t>& points) {
  const auto count = static_cast<std::size_t>(checkpoint.length(entry_of("mass")));
  const auto stored =
      checkpoint.doubles(entry_of(column), static_cast<Index>(count) * static_cast<Index>(num_components));
  std::vector<double> values;
  values.reserve(points.size() * static_cast<std::size_t>(num_components));
  for (std::size_t c = 0; c < static_cast<std::size_t>(num_components); ++c) {
    for (const std::size_t p : points) values.push_back(stored[c * count + p]);
  }
  return values;
}

StoredScene find_stored_points(const std::filesystem::path& path, const Scene& scene) {
  const io::Checkpoint checkpoint = open_checkpoint(path);
  StoredScene stored{path, checkpoint.text("traits"), {}, {}};
  const std::string differences = difference(stored.traits, traits_of_points(scene));
  require(differences.empty(), path.string() + ": holds points of another kind: " + differences);
  stored.spacing = checkpoint.doubles("spacing", scene.mesh.dimensions);
  stored.columns = lines_of(checkpoint.text("columns"));
  require(!heavy_points(checkpoint).empty(), path.string() + ": holds no point");
  return stored;
}

BoxRegion extent_of(const StoredScene& stored, const MeshScene& mesh) {
  const io::Checkpoint checkpoint = open_checkpoint(stored.path);
  const auto points = heavy_points(checkpoint);
  const auto positions = values_of(checkpoint, "position", mesh.dimensions, points);
  BoxRegion box;
  for (auto axis = positions.begin(); axis != positions.end(); axis += static_cast<Index>(points.size())) {
    const auto [low, high] = std::minmax_element(axis, axis + static_cast<Index>(points.size()));
    box.low.push_back(*low);
    box.high.push_back(*high);
  }
  return box;
}

}  // namespace scree::app
