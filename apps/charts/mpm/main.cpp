#include "../cpu_time.hpp"
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
  std::vector<Run> (*run)(const Scheme&, bool is_quick);
};

constexpr std::array<Problem, 3> problems{
    {{"swing", swing}, {"turning_ring", turning_ring}, {"collapse", collapse}}};

void write_rows(const std::vector<Run>& runs, std::ostream& out) {
  for (const Run& run : runs) {
    const auto& [shape, transfer, any_shape, any_transfer, order, xpic_order, points] = run.scheme;
    out << fmt::format("{},{},{},{},{},{},{:.4g},{:.10g}\n", run.problem, shape, transfer,
                       scree::mpm::order_names.at(static_cast<std::size_t>(order)), points, run.cells,
                       run.cpu_seconds, run.error);
  }
  out.flush();
}

/// Runs the chosen problems, or all; what is done is in the table as soon as it is.
void run(bool is_quick, const std::vector<std::string>& chosen, std::ostream& table) {
  table << "problem,shape,transfer,order,points_per_axis,cells,cpu_seconds,error\n";
  for (const Problem& problem : problems) {
    if (!chosen.empty() && std::ranges::find(chosen, problem.name) == chosen.end()) continue;
    const double start = cpu_seconds();
    for (const Scheme& scheme : every_scheme(is_quick)) write_rows(problem.run(scheme, is_quick), table);
    fmt::print("{:25s} {:7.1f} s\n", problem.name, cpu_seconds() - start);
    std::fflush(stdout);
  }
}

int parse_and_run(int argc, char** argv) {
  CLI::App program{"scree_mpm_charts: error and cost of every way to step material points"};
  std::string output;
  std::vector<std::string> chosen;
  bool is_quick = false;
  std::vector<std::string> names;
  names.reserve(problems.size());
  for (const Problem& problem : problems) names.emplace_back(problem.name);
  program.add_option("--output,-o", output, "table to write (CSV)")->required();
  program.add_option("--problem", chosen, "only this problem; may be given again")
      ->check(CLI::IsMember(names));
  program.add_flag("--quick", is_quick, "quadratic splines on the coarsest mesh: to try it");
  CLI11_PARSE(program, argc, argv);
  std::ofstream file{output};
  if (!file) throw std::runtime_error{"cannot write " + output};
  run(is_quick, chosen, file);
  file.close();
  if (!file) throw std::runtime_error{"cannot write " + output};
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return parse_and_run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "scree_mpm_charts: {}\n", error.what());
    return 1;
  }
}
