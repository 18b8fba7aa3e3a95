#pragma once

#include <filesystem>
#include <string>

namespace scree::app {

/// Draws the pictures of a directory into it, by a Python script beside the program: "plot_run.py" those of a
/// run, "plot_path.py" that of a path.
/// @returns the script's exit code.  @throws RunError if it cannot be started.
[[nodiscard]] int plot(const std::string& name, const std::filesystem::path& directory);

}  // namespace scree::app
