#pragma once

#include <algorithm>
#include <ctime>

namespace scree::charts {

/// How long to measure one run.
struct Effort {
  int samples = 5;               ///< at most
  double sample_seconds = 2e-3;  ///< runs that are shorter are repeated to fill it [s]
  double enough_seconds = 0.2;   ///< no further sample after this much [s]
};

/// CPU time of this process [s].
[[nodiscard]] inline double cpu_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// CPU time of one call of `run` [s]: the best of a few samples, short calls repeated within each.
template <class Run>
[[nodiscard]] double best_cpu_seconds(Run&& run, const Effort& effort) {
  const auto seconds_of = [&](int calls) {
    const double start = cpu_seconds();
    for (int call = 0; call < calls; ++call) run();
    return cpu_seconds() - start;
  };
  int calls = 1;
  double spent = seconds_of(calls);
  while (spent < effort.sample_seconds) {
    calls *= 2;
    spent = seconds_of(calls);
  }
  double best = spent / calls;
  for (int sample = 1; sample < effort.samples && spent < effort.enough_seconds; ++sample) {
    const double seconds = seconds_of(calls);
    best = std::min(best, seconds / calls);
    spent += seconds;
  }
  return best;
}

}  // namespace scree::charts
