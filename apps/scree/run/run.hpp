#pragma once

#include "scree/scene/scene.hpp"

#include <scree/blocks.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scree::app {

struct RunOptions {
  std::filesystem::path directory;
  Threads threads;
  std::optional<std::filesystem::path> restart;  ///< checkpoint to go on from
  bool is_quiet = false;
};

/// How a run ended; the numbers are the program's exit codes.
enum class Outcome { finished = 0, failed = 3, interrupted = 130 };

/// Runs a scene to its end, or until Ctrl-C or a failure; whatever happens, the directory holds what was
/// written until then, readable, and a checkpoint.
/// @throws InputError if the scene, the directory or the checkpoint will not do.
[[nodiscard]] Outcome run_scene(const ReadScene& scene, const RunOptions& options);

/// What a scene would cost: points, cells, step and what bounds it, memory; in lines for people.
/// @throws InputError if its parts do not fit each other.
[[nodiscard]] std::string cost_of(const Scene& scene);

/// Every limiter, flux, closure, law, shape, transfer and wall, one line each.
[[nodiscard]] std::string list_of_parts();

/// Averages of a stored frame over equal parts of the depth, as CSV: y,velocity,mean_grain_size,phi_1,..
/// @param time the stored frame nearest it is taken [s]; the last one if there is none
/// @param num_parts of the depth of the material at rest; the mesh cells it fills if there is none
/// @throws InputError if the directory holds no readable run.
[[nodiscard]] std::string profile_csv(const std::filesystem::path& directory, std::optional<double> time,
                                      std::optional<int> num_parts);

}  // namespace scree::app
