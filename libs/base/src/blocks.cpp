#include <scree/blocks.hpp>

#include <omp.h>

namespace scree {

namespace detail {
void run_blocks(Index num_blocks, Threads threads, void* context, BlockBody body) {
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads.count)
  for (Index block = 0; block < num_blocks; ++block) body(context, block);
}
}  // namespace detail

double ordered_sum(std::span<const double> terms) noexcept {
  double sum = 0;
  for (const double term : terms) sum += term;
  return sum;
}

}  // namespace scree
