#include "gas.hpp"

namespace scree::charts {

std::vector<Record> run_gas(const std::string& problem, Index n, const GasCase& start, const Effort& effort) {
  return run_every_scheme(problem, n, std::vector{start}, effort);
}

}  // namespace scree::charts
