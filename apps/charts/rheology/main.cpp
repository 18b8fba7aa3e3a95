#include "../program.hpp"
#include "problems.hpp"

namespace {

using namespace scree::charts;

[[nodiscard]] Extent extent_of(bool is_quick) {
  Extent extent{.is_quick = is_quick, .effort = {}};
  if (is_quick) extent.effort = {.samples = 1, .sample_seconds = 0, .enough_seconds = 0};
  return extent;
}

[[nodiscard]] Problem problem(const char* name, std::vector<Run> (*run)(const Extent&)) {
  return {name, [run](bool is_quick, std::ostream& table) { write_rows(run(extent_of(is_quick)), table); }};
}

}  // namespace

int main(int argc, char** argv) {
  return run_program(
      {.name = "scree_rheology_charts",
       .summary = "error and cost of what advances stiff rheology",
       .quick = "one parameter, few steps, measured once",
       .write_titles = write_titles,
       .problems = {problem("newtonian_layer", newtonian_layer), problem("bingham_layer", bingham_layer),
                    problem("granular_point", granular_point),
                    problem("yield_stress_point", yield_stress_point)}},
      argc, argv);
}
