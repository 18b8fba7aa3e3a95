#pragma once

#include <filesystem>
#include <string_view>

namespace scree::io {

/// What a file outlives from the moment on that its writer has returned.
enum class Durability {
  kill,       ///< the program's end, however sudden; the system brings it to the disk within a minute or so
  power_cut,  ///< the machine's, too; waits for the disk, some 5 ms and more
};

/// Puts `bytes` in the place of a file, or makes it, in one move: written beside it under its name with
/// ".partial" added, then renamed.
///
/// Whatever ends the program, `path` holds the old file or the new one, never a part.
/// @throws RunError naming `path` and the system's reason, for instance a full disk; the old file then stays
/// and the part is removed.
void replace_file(const std::filesystem::path& path, std::string_view bytes,
                  Durability durability = Durability::power_cut);

}  // namespace scree::io
