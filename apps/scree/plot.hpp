#pragma once

#include <filesystem>

namespace scree::app {

/// Draws the pictures of a run into its directory, by the Python script beside the program.
/// @returns the script's exit code.  @throws RunError if it cannot be started.
[[nodiscard]] int plot_run(const std::filesystem::path& directory);

}  // namespace scree::app
