#pragma once

#include <filesystem>
#include <string>

namespace scree::io::detail {

/// All bytes of a file.  @throws InputError naming it and the system's reason.
[[nodiscard]] std::string read_bytes(const std::filesystem::path& path);

}  // namespace scree::io::detail
