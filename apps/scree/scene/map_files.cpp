#include "scree/scene/map_files.hpp"

#include "scree/scene/checkpoint_points.hpp"

#include <scree/io/esri_ascii.hpp>
#include <scree/io/stl.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace scree::app {

namespace {

using io::TomlTable;

/// What lies beside a scene goes with its results, so that these can be read again on their own.
[[nodiscard]] bool climbs(const std::filesystem::path& name) {
  return name.is_relative() && std::ranges::find(name, std::filesystem::path{".."}) != name.end();
}

/// The cells of a map that reach over [low, high] of the map, along an axis: from the first to before the
/// second; those beyond the map too.
[[nodiscard]] std::array<Index, 2> cells_over(double first, double cell_size, double low, double high) {
  constexpr double slack = 1e-6;  // [-], of a cell of the map: its numbers are rounded to few digits
  const double edge = first - cell_size / 2;
  return {static_cast<Index>(std::floor((low - edge) / cell_size + slack)),
          static_cast<Index>(std::ceil((high - edge) / cell_size - slack))};
}

}  // namespace

template <class Read>
auto SceneFiles::read(const TomlTable& table, std::string_view meaning, std::string_view key,
                      const Read& read_file) -> std::optional<decltype(read_file(std::filesystem::path{}))> {
  const std::filesystem::path name = table.string(key, meaning);
  if (!table.is_sound(key)) return std::nullopt;
  table.check(!climbs(name), {key},
              "must lie beside the scene or below it, or be an absolute path: it is kept with the results");
  if (!table.is_sound(key)) return std::nullopt;
  try {
    const std::filesystem::path path = name.is_relative() ? folder_ / name : name;
    auto content = read_file(path);
    files_.push_back({name, path});
    return content;
  } catch (const InputError& error) {
    table.add_fault(key, error.what());
    return std::nullopt;
  }
}

std::optional<Raster> SceneFiles::read_raster(const TomlTable& table, std::string_view meaning,
                                              std::string_view key) {
  return read(table, meaning, key,
              [](const std::filesystem::path& path) { return io::read_esri_ascii(path); });
}

std::optional<TriangleMesh> SceneFiles::read_triangles(const TomlTable& table, std::string_view meaning) {
  return read(table, meaning, "file", [](const std::filesystem::path& path) { return io::read_stl(path); });
}

std::optional<StoredScene> SceneFiles::find_points(const TomlTable& table, const Scene& scene) {
  return read(table, "checkpoint of another run, of which the points are taken", "checkpoint",
              [&](const std::filesystem::path& path) { return find_stored_points(path, scene); });
}

MapPlace read_map_place(const TomlTable& table, const MapPlace& fallback) {
  MapPlace place = fallback;
  if (table.has("origin")) {
    const auto origin =
        table.numbers("origin", "place on the map of the mesh's origin [m]", io::any_value(), 2);
    if (origin.size() == 2) place.origin = {origin[0], origin[1]};
  }
  place.datum = table.number_or(fallback.datum, "datum", "height on the map of y = 0 [m]");
  return place;
}

std::string gap_in_map(const RasterScene& map, const MeshScene& mesh, bool may_have_holes) {
  const Raster& raster = map.heights;
  if (raster.num_columns < 2 || raster.num_rows < 2) return "the map must have at least 2 x 2 cells";
  const std::array<double, 2> lengths{mesh.size[0], mesh.size[2]};
  const std::array<Index, 2> counts{raster.num_columns, raster.num_rows};
  std::array<std::array<Index, 2>, 2> cells{};
  for (std::size_t d = 0; d < 2; ++d) {
    const double first = raster.first[static_cast<int>(d)];
    const double low = map.place.origin[d];
    cells[d] = cells_over(first, raster.cell_size, low, low + lengths[d]);
    if (cells[d][0] >= 0 && cells[d][1] <= counts[d]) continue;
    const double edge = first - raster.cell_size / 2;
    return fmt::format(
        "the map reaches from {:.10g} to {:.10g} m to the {}, and the mesh from {:.10g} to {:.10g} m", edge,
        edge + raster.cell_size * static_cast<double>(counts[d]), d == 0 ? "east" : "north", low,
        low + lengths[d]);
  }
  if (may_have_holes) return {};
  for (std::size_t d = 0; d < 2; ++d) {  // heights between centres are drawn from the cells around
    cells[d] = {std::max<Index>(cells[d][0] - 1, 0), std::min(cells[d][1] + 1, counts[d])};
  }
  for (Index row = cells[1][0]; row < cells[1][1]; ++row) {
    for (Index column = cells[0][0]; column < cells[0][1]; ++column) {
      if (std::isfinite(raster.values[static_cast<std::size_t>(row * counts[0] + column)])) continue;
      return fmt::format(
          "the map has no value at ({:.10g}, {:.10g}) m, under the mesh: in its row {} from the north, "
          "column {}",
          raster.first[0] + raster.cell_size * static_cast<double>(column),
          raster.first[1] + raster.cell_size * static_cast<double>(row), counts[1] - row, column + 1);
    }
  }
  return {};
}

}  // namespace scree::app
