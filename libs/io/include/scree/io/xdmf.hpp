#pragma once

#include <scree/io/frame.hpp>

#include <span>
#include <string>

namespace scree::io {

/// The XDMF 3 document by which ParaView and VisIt read `frames`: one cloud of points per instant.
///
/// It names the frames' own HDF5 files, relative to its own folder. Vectors and tensors are one attribute
/// each, a column of classes one scalar per class, `<name>_1`..; each name ends with its unit: "speed [m/s]".
/// @param frames in order of time, each with a column `position`.
[[nodiscard]] std::string to_xdmf(std::span<const StoredFrame> frames);

}  // namespace scree::io
