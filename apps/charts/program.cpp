#include "program.hpp"

#include "cpu_time.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>

namespace scree::charts {

namespace {

void run(const Program& program, bool is_quick, const std::vector<std::string>& chosen, std::ostream& table) {
  program.write_titles(table);
  for (const Problem& problem : program.problems) {
    if (!chosen.empty() && std::ranges::find(chosen, problem.name) == chosen.end()) continue;
    const double start = cpu_seconds();
    problem.run(is_quick, table);
    fmt::print("{:25s} {:7.1f} s\n", problem.name, cpu_seconds() - start);
    std::fflush(stdout);
  }
}

int parse_and_run(const Program& program, int argc, char** argv) {
  CLI::App arguments{program.name + ": " + program.summary};
  std::string output;
  std::vector<std::string> chosen;
  bool is_quick = false;
  std::vector<std::string> names;
  names.reserve(program.problems.size());
  for (const Problem& problem : program.problems) names.push_back(problem.name);
  arguments.add_option("--output,-o", output, "table to write (CSV)")->required();
  arguments.add_option("--problem", chosen, "only this problem; may be given again")
      ->check(CLI::IsMember(names));
  arguments.add_flag("--quick", is_quick, program.quick + ": to try it");
  CLI11_PARSE(arguments, argc, argv);
  std::ofstream file{output};
  if (!file) throw std::runtime_error{"cannot write " + output};  // before the minutes it takes
  run(program, is_quick, chosen, file);
  file.close();
  if (!file) throw std::runtime_error{"cannot write " + output};
  return 0;
}

}  // namespace

int run_program(const Program& program, int argc, char** argv) {
  try {
    return parse_and_run(program, argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", program.name, error.what());
    return 1;
  }
}

}  // namespace scree::charts
