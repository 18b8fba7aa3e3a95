#include "../program.hpp"
#include "problems.hpp"

namespace {

using namespace scree::charts;

[[nodiscard]] Extent extent_of(bool is_quick) {
  Extent extent{.is_quick = is_quick, .effort = {}};
  if (is_quick) extent.effort = {.samples = 1, .sample_seconds = 0, .enough_seconds = 0};
  return extent;
}

[[nodiscard]] Problem problem(const char* name, std::vector<Record> (*run)(const Extent&)) {
  return {name, [run](bool is_quick, std::ostream& table) { write_rows(run(extent_of(is_quick)), table); }};
}

}  // namespace

int main(int argc, char** argv) {
  return run_program({.name = "scree_charts",
                      .summary = "error and cost of every transport scheme on problems with known solutions",
                      .quick = "the two coarsest grids, measured once",
                      .write_titles = write_titles,
                      .problems = {problem("advection", advection), problem("burgers_smooth", burgers_smooth),
                                   problem("burgers_shock", burgers_shock), problem("sod", sod),
                                   problem("shu_osher", shu_osher), problem("slotted_disk", slotted_disk),
                                   problem("segregation_two_sizes", segregation_two_sizes),
                                   problem("segregation_five_sizes", segregation_five_sizes)}},
                     argc, argv);
}
