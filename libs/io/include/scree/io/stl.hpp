#pragma once

#include <scree/triangle_mesh.hpp>

#include <filesystem>
#include <string>
#include <string_view>

namespace scree::io {

/// Reads a surface in the STL format, binary or text. Corners at the same place become one vertex; the order
/// of corners says which way a triangle faces, the normals that are written are not read.
/// @throws InputError naming the file, and the line of a text, if it cannot be read, ends too early or holds
/// something else, no triangle, or a corner that is not finite.
[[nodiscard]] TriangleMesh read_stl(const std::filesystem::path& path);

/// The same of a file's bytes; `name` stands for the file in messages.
[[nodiscard]] TriangleMesh parse_stl(std::string_view bytes, const std::string& name);

}  // namespace scree::io
