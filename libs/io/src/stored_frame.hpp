#pragma once

#include <scree/io/frame.hpp>

#include <filesystem>
#include <string>

namespace scree::io::detail {

[[nodiscard]] std::string to_name(ColumnKind kind);

/// Writes a frame that was found sound as the file `directory`/stored.file().
void write_frame(const std::filesystem::path& directory, const StoredFrame& stored, const Frame& frame);

/// What the file of the frame `name` holds.  @throws InputError if it cannot be read.
[[nodiscard]] StoredFrame read_stored_frame(const std::filesystem::path& directory, const std::string& name);

}  // namespace scree::io::detail
