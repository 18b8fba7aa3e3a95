#include "gas.hpp"

#include <limits>
#include <memory>

namespace scree::charts {

GasCase between_open_ends(const Lattice<1>& cells, double duration) {
  using Open = transport::UserGiven<1, 3>;
  constexpr Index questions_per_cell = 100;  // two ends, up to three stages: 16 times the usual steps or more
  const auto left = std::make_shared<Index>();
  const Open end{[left](const Open::State& inside, const transport::BoundaryFace<1>& /*face*/) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return (*left)-- > 0 ? inside : Open::State{nan, nan, nan};  // the solver reports it
  }};
  return {.grid = cells,
          .law = transport::Euler<1>{},
          .boundaries = {{{end, end}}},
          .start = {},
          .exact = {},
          .duration = duration,
          .before_run = [left, n = cells.count[0]] { *left = questions_per_cell * n; }};
}

std::vector<Record> run_gas(const std::string& problem, Index n, const GasCase& start, const Effort& effort) {
  auto records = run_every_scheme(problem, n, std::vector{start}, effort);
  std::ranges::copy(run_gas_in_primitives(problem, n, start, effort), std::back_inserter(records));
  return records;
}

}  // namespace scree::charts
