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
  std::vector<Record> (*run)(const Extent&);
};

constexpr std::array<Problem, 8> problems{{{"advection", advection},
                                           {"burgers_smooth", burgers_smooth},
                                           {"burgers_shock", burgers_shock},
                                           {"sod", sod},
                                           {"shu_osher", shu_osher},
                                           {"slotted_disk", slotted_disk},
                                           {"segregation_two_sizes", segregation_two_sizes},
                                           {"segregation_five_sizes", segregation_five_sizes}}};

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
  CLI::App program{"scree_charts: error and cost of every transport scheme on problems with known solutions"};
  std::string output;
  std::vector<std::string> chosen;
  Extent extent;
  std::vector<std::string> names;
  names.reserve(problems.size());
  for (const Problem& problem : problems) names.emplace_back(problem.name);
  program.add_option("--output,-o", output, "table to write (CSV)")->required();
  program.add_option("--problem", chosen, "only this problem; may be given again")
      ->check(CLI::IsMember(names));
  program.add_flag("--quick", extent.is_quick, "the two coarsest grids, measured once: to try it");
  CLI11_PARSE(program, argc, argv);
  if (extent.is_quick) extent.effort = {.samples = 1, .sample_seconds = 0, .enough_seconds = 0};
  std::ofstream file{output};
  if (!file) throw std::runtime_error{"cannot write " + output};  // before the minutes it takes
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
    fmt::print(stderr, "scree_charts: {}\n", error.what());
    return 1;
  }
}
