#pragma once

#include <scree/raster.hpp>

#include <filesystem>
#include <string>
#include <string_view>

namespace scree::io {

/// Reads a map in the ESRI ASCII format: `ncols`, `nrows`, `xllcorner` and `yllcorner` (of the outermost
/// cell's corner) or `xllcenter` and `yllcenter` (of its centre), `cellsize`, and, if wanted, `nodata_value`,
/// in any order; then the values row by row, the northernmost first. Values that equal nodata_value become
/// NaN.
/// @throws InputError naming the file, and the line where there is one, if it cannot be read, a key is
/// unknown, missing or twice, corners and centres are mixed, or it does not hold ncols x nrows numbers.
[[nodiscard]] Raster read_esri_ascii(const std::filesystem::path& path);

/// The same of a text; `name` stands for the file in messages.
[[nodiscard]] Raster parse_esri_ascii(std::string_view text, const std::string& name);

}  // namespace scree::io
