#pragma once

#include "scree/scene/path_file.hpp"

#include <scree/rheology/path/drive.hpp>

#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace scree::app {

/// The point at rest that a path begins with.
/// @throws RunError if the law has no density at which it bears the pressure.
[[nodiscard]] std::unique_ptr<rheology::PathPoint> start_of(const PathFile& file);

/// The records of a path as CSV, a line each: name [unit] of each column, then its numbers. What the law has
/// not (inertial number, stability number) has no column; its memory has one for each number.
[[nodiscard]] std::string csv_of(const rheology::PathPoint& point,
                                 std::span<const rheology::PathRecord> records);

/// Leads the point of a file along its path and writes `path.csv` into a directory; what was reached is
/// written even if a step has no answer.
/// @throws RunError if it has none, or if the file cannot be written.
void run_path(const PathFile& file, const std::filesystem::path& directory);

}  // namespace scree::app
