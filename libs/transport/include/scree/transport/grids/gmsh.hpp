#pragma once

#include <scree/transport/grids/polygonal_mesh.hpp>

#include <filesystem>
#include <istream>
#include <string_view>

namespace scree::transport {

/// Reads a plane mesh that Gmsh wrote: format 4.1, ASCII; triangles and quadrilaterals are the cells, lines
/// in a physical group its boundary edges, the group's name the boundary's (its number where it has none).
///
/// Lines in no group are passed over, and so are points, and sections that are not needed ($Periodic,
/// $NodeData, ..). Nothing is renumbered but to make the numbers consecutive.
/// @param file what messages call the input
/// @throws InputError naming file, line and what was expected there.
[[nodiscard]] PolygonalMesh read_gmsh(std::istream& input, std::string_view file);

/// The same from a file.  @throws InputError also if it cannot be opened.
[[nodiscard]] PolygonalMesh read_gmsh(const std::filesystem::path& path);

}  // namespace scree::transport
