#include "scree/plot.hpp"
#include "scree/run/run.hpp"
#include "scree/run/run_path.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <string>
#include <thread>
#include <vector>

namespace {

constexpr int exit_bad_input = 2;
constexpr int exit_failed = static_cast<int>(scree::app::Outcome::failed);

/// What the command line says.
struct Arguments {
  std::string scene;
  std::vector<std::string> overrides;
  std::string output;
  std::string restart;
  int threads = 0;
  bool is_quiet = false;
  bool has_no_picture = false;
  std::string directory;
  double time = 0;
  int cells = 0;
};

int run(const Arguments& arguments) {
  const auto scene = scree::app::read_scene(arguments.scene, arguments.overrides);
  scree::app::RunOptions options;
  options.directory = arguments.output.empty()
                          ? std::filesystem::path{"out"} / std::filesystem::path{arguments.scene}.stem()
                          : std::filesystem::path{arguments.output};
  options.threads.count = arguments.threads > 0
                              ? arguments.threads
                              : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  options.is_quiet = arguments.is_quiet;
  if (!arguments.restart.empty()) options.restart = arguments.restart;
  const auto outcome = scree::app::run_scene(scene, options);
  if (!arguments.is_quiet) fmt::print("results are in {}\n", options.directory.string());
  return static_cast<int>(outcome);
}

int lead(const Arguments& arguments) {
  const auto file = scree::app::read_path_file(arguments.scene, arguments.overrides);
  const std::filesystem::path directory =
      arguments.output.empty()
          ? std::filesystem::path{"out"} / "paths" / std::filesystem::path{arguments.scene}.stem()
          : std::filesystem::path{arguments.output};
  scree::app::run_path(file, directory);
  fmt::print("{}\n", (directory / "path.csv").string());
  std::fflush(stdout);  // before the script prints
  return arguments.has_no_picture ? 0 : scree::app::plot("plot_path.py", directory);
}

void add_scene_options(CLI::App& command, Arguments& arguments) {
  command.add_option("scene", arguments.scene, "scene file (TOML)")->required();
  command.add_option("--set", arguments.overrides, "table.key=value, instead of what the scene says")
      ->allow_extra_args(false);
}

void add_run(CLI::App& program, Arguments& arguments, int& exit_code) {
  CLI::App* command = program.add_subcommand("run", "run a scene");
  add_scene_options(*command, arguments);
  command->add_option("--output,-o", arguments.output, "directory of the results; out/SCENE if left out");
  command->add_option("--threads", arguments.threads, "threads; all cores if left out")
      ->check(CLI::PositiveNumber);
  command->add_option("--restart", arguments.restart, "checkpoint to go on from");
  command->add_flag("--quiet", arguments.is_quiet, "print nothing but errors");
  command->callback([&] { exit_code = run(arguments); });
}

void add_path(CLI::App& program, Arguments& arguments, int& exit_code) {
  CLI::App* command =
      program.add_subcommand("path", "lead one material point along a path: CSV and a picture");
  command->add_option("path", arguments.scene, "path file (TOML)")->required();
  command->add_option("--set", arguments.overrides, "table.key=value, instead of what the file says")
      ->allow_extra_args(false);
  command->add_option("--output,-o", arguments.output,
                      "directory of the results; out/paths/PATH if left out");
  command->add_flag("--no-picture", arguments.has_no_picture, "write the CSV alone");
  command->callback([&] { exit_code = lead(arguments); });
}

void add_check(CLI::App& program, Arguments& arguments) {
  CLI::App* command =
      program.add_subcommand("check", "find all faults of a scene, and what running it would cost");
  add_scene_options(*command, arguments);
  command->callback([&] {
    fmt::print("{}", scree::app::cost_of(scree::app::read_scene(arguments.scene, arguments.overrides).scene));
  });
}

void add_plot(CLI::App& program, Arguments& arguments, int& exit_code) {
  CLI::App* command = program.add_subcommand("plot", "draw the pictures of a run into its directory");
  command->add_option("directory", arguments.directory, "directory of the run")->required();
  command->callback([&] { exit_code = scree::app::plot("plot_run.py", arguments.directory); });
}

void add_profile(CLI::App& program, Arguments& arguments) {
  CLI::App* command = program.add_subcommand("profile", "averages over the depth, as CSV");
  command->add_option("directory", arguments.directory, "directory of the run")->required();
  CLI::Option* time =
      command->add_option("--time", arguments.time, "simulated time [s]; the last frame if left out");
  CLI::Option* cells =
      command->add_option("--cells", arguments.cells, "parts of the depth; its cells if left out");
  command->callback([&arguments, time, cells] {
    fmt::print("{}", scree::app::profile_csv(arguments.directory,
                                             *time ? std::optional<double>{arguments.time} : std::nullopt,
                                             *cells ? std::optional<int>{arguments.cells} : std::nullopt));
  });
}

int parse_and_run(int argc, char** argv) {
  CLI::App program{"scree: flowing granular material that sorts its grains by size"};
  program.set_version_flag("--version", "scree " SCREE_VERSION);
  program.require_subcommand(1);
  Arguments arguments;
  int exit_code = 0;
  add_run(program, arguments, exit_code);
  add_check(program, arguments);
  add_path(program, arguments, exit_code);
  add_plot(program, arguments, exit_code);
  add_profile(program, arguments);
  program.add_subcommand("list", "everything a scene can name, one line each")->callback([] {
    fmt::print("{}", scree::app::list_of_parts());
  });
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : exit_bad_input;
  }
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return parse_and_run(argc, argv);
  } catch (const scree::RunError& error) {
    fmt::print(stderr, "scree: {}\n", error.what());
    return exit_failed;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return exit_bad_input;
  }
}
