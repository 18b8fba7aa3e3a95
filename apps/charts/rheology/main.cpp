#include "problems.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string_view>

namespace {

using namespace scree::charts;

struct Problem {
  std::string_view name;
  std::vector<Run> (*run)(const Extent&);
};

constexpr std::array<Problem, 4> problems{{{"newtonian_layer", newtonian_layer},
                                           {"bingham_layer", bingham_layer},
                                           {"granular_point", granular_point},
                                           {"yield_stress_point", yield_stress_point}}};

/// Runs the chosen problems, or all; what is done is in the table as soon as it is.
void run(const Extent& extent, const std::vector<std::string>& chosen, std::ostream& table) {
  write_titles(table);
  for (const Problem& problem : problems) {
    if (!chosen.empty() && std::ranges::find(chosen, problem.name) == chosen.end()) continue;
    const double start = cpu_seconds();
    write_rows(problem.run(extent), table);
    fmt::print("{:25s} {:7.1f} s\n", problem.name, cpu_seconds() - start);
    std::fflush(stdout);
  }
}

int parse_and_run(int argc, char** argv) {
  CLI::App program{"scree_rheology_charts: error and cost of what advances stiff rheology"};
  std::string output;
  std::vector<std::string> chosen;
  Extent extent;
  std::vector<std::string> names;
  names.reserve(problems.size());
  for (const Problem& problem : problems) names.emplace_back(problem.name);
  program.add_option("--output,-o", output, "table to write (CSV)")->required();
  program.add_option("--problem", chosen, "only this problem; may be given again")
      ->check(CLI::IsMember(names));
  program.add_flag("--quick", extent.is_quick, "one parameter, few steps, measured once: to try it");
  CLI11_PARSE(program, argc, argv);
  if (extent.is_quick) extent.effort = {.samples = 1, .sample_seconds = 0, .enough_seconds = 0};
  std::ofstream file{output};
  if (!file) throw std::runtime_error{"cannot write " + output};
  run(extent, chosen, file);
  file.close();
  if (!file) throw std::runtime_error{"cannot write " + output};
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return parse_and_run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "scree_rheology_charts: {}\n", error.what());
    return 1;
  }
}
