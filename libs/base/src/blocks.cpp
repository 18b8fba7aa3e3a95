#include <scree/blocks.hpp>

#include <omp.h>

#include <algorithm>
#include <array>
#include <atomic>

namespace scree {

namespace {

/// Consecutive blocks that have one thread of their own; on a cache line of its own.
struct alignas(64) Share {
  std::atomic<Index> next{0};
  Index end = 0;
};

constexpr Index max_shares = 128;  // more threads than this begin with a share of another

}  // namespace

namespace detail {
/// A thread has the same blocks in each of a step's loops, so that what they touch stays in its cache, and
/// helps others when it is done. Neither who takes a block nor when matters to what the body does.
void run_blocks(Index num_blocks, Threads threads, void* context, BlockBody body) {
  const Index count = std::min({Index{threads.count}, num_blocks, max_shares});
  std::array<Share, max_shares> shares;
  for (Index i = 0; i < count; ++i) {
    Share& share = shares[static_cast<std::size_t>(i)];
    share.next.store(num_blocks * i / count, std::memory_order_relaxed);
    share.end = num_blocks * (i + 1) / count;
  }
#pragma omp parallel num_threads(threads.count)
  {
    for (Index turn = 0; turn < count; ++turn) {
      Share& share = shares[static_cast<std::size_t>((omp_get_thread_num() + turn) % count)];
      const auto take = [&share] { return share.next.fetch_add(1, std::memory_order_relaxed); };
      for (Index block = take(); block < share.end; block = take()) body(context, block);
    }
  }
}
}  // namespace detail

double ordered_sum(std::span<const double> terms) noexcept {
  double sum = 0;
  for (const double term : terms) sum += term;
  return sum;
}

}  // namespace scree
