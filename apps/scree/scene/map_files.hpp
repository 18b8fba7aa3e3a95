#pragma once

#include "scree/scene/scene.hpp"

#include <scree/io/toml_reader.hpp>

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace scree::app {

/// Finds and reads the files that a scene names, and remembers which.
class SceneFiles {
 public:
  /// @param folder of the scene, which names of files start from
  explicit SceneFiles(std::filesystem::path folder) : folder_{std::move(folder)} {}

  /// A map in the ESRI ASCII format; nothing if the key or the file is at fault.
  [[nodiscard]] std::optional<Raster> read_raster(const io::TomlTable& table, std::string_view meaning,
                                                  std::string_view key = "file");
  /// A surface in the STL format; nothing if the key or the file is at fault.
  [[nodiscard]] std::optional<TriangleMesh> read_triangles(const io::TomlTable& table,
                                                           std::string_view meaning);

  /// The checkpoint of another run that a key `checkpoint` names; nothing if the key or the file is at fault.
  [[nodiscard]] std::optional<StoredScene> find_points(const io::TomlTable& table, const Scene& scene);

  [[nodiscard]] const std::vector<FileOfScene>& files() const noexcept { return files_; }

 private:
  template <class Read>
  [[nodiscard]] auto read(const io::TomlTable& table, std::string_view meaning, std::string_view key,
                          const Read& read_file)
      -> std::optional<decltype(read_file(std::filesystem::path{}))>;

  std::filesystem::path folder_;
  std::vector<FileOfScene> files_;
};

/// Where on its map the mesh lies, keys `origin` and `datum`.
/// @param fallback for keys that are left out
[[nodiscard]] MapPlace read_map_place(const io::TomlTable& table, const MapPlace& fallback = {});

/// What is wrong with a map for a mesh: does it reach over all of it, and has it a value everywhere there?
/// @returns a message, empty if nothing is.
[[nodiscard]] std::string gap_in_map(const RasterScene& map, const MeshScene& mesh, bool may_have_holes);

}  // namespace scree::app
