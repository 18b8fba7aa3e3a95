#include "gas.hpp"

// A file of its own, so that none takes long to compile.
namespace scree::charts {

std::vector<Record> run_gas_in_primitives(const std::string& problem, Index n, const GasCase& start,
                                          const Effort& effort) {
  const std::vector places{start};
  std::vector<Record> records;
  for_each_reconstruction_in_primitives(start.law, [&](const auto& reconstruction, const std::string& label) {
    const Record named{.problem = problem, .scheme = "primitive", .limiter = label, .n = n};
    std::ranges::copy(run_reconstruction(named, reconstruction, places, effort), std::back_inserter(records));
  });
  return records;
}

}  // namespace scree::charts
