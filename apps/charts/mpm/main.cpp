#include "../program.hpp"
#include "problems.hpp"

#include <fmt/format.h>

namespace {

using namespace scree::charts;

void write_rows(const std::vector<Run>& runs, std::ostream& out) {
  for (const Run& run : runs) {
    const auto& [shape, transfer, any_shape, any_transfer, order, xpic_order, points] = run.scheme;
    out << fmt::format("{},{},{},{},{},{},{:.4g},{:.10g}\n", run.problem, shape, transfer,
                       scree::mpm::order_names.at(static_cast<std::size_t>(order)), points, run.cells,
                       run.cpu_seconds, run.error);
  }
  out.flush();
}

[[nodiscard]] Problem problem(const char* name, std::vector<Run> (*run)(const Scheme&, bool is_quick)) {
  return {name, [run](bool is_quick, std::ostream& table) {
            for (const Scheme& scheme : every_scheme(is_quick)) write_rows(run(scheme, is_quick), table);
          }};
}

}  // namespace

int main(int argc, char** argv) {
  return run_program({.name = "scree_mpm_charts",
                      .summary = "error and cost of every way to step material points",
                      .quick = "quadratic splines on the coarsest mesh",
                      .write_titles =
                          [](std::ostream& table) {
                            table << "problem,shape,transfer,order,points_per_axis,cells,cpu_seconds,error\n";
                          },
                      .problems = {problem("swing", swing), problem("turning_ring", turning_ring),
                                   problem("collapse", collapse)}},
                     argc, argv);
}
