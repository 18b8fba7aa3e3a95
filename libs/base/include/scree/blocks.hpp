#pragma once

#include <scree/tensor.hpp>

#include <memory>
#include <span>

namespace scree {

/// How many threads a loop may use. A value, handed to each loop: there is no global setting.
struct Threads {
  int count = 1;
};

namespace detail {
using BlockBody = void (*)(void* context, Index block);
/// Calls body(context, 0..num_blocks-1), each once, in any order, on up to `threads` threads.
void run_blocks(Index num_blocks, Threads threads, void* context, BlockBody body);
}  // namespace detail

/// Calls body(block) for every block in 0..num_blocks-1, in any order and on up to `threads` threads.
///
/// Bodies must not touch each other's data, then the result does not depend on the number of threads.
/// The body must not throw. One indirect call per block; no OpenMP in this header.
template <class Body>
void for_each_block(Index num_blocks, Threads threads, Body&& body) {
  if (threads.count <= 1 || num_blocks <= 1) {
    for (Index block = 0; block < num_blocks; ++block) body(block);
    return;
  }
  using Callable = std::remove_cvref_t<Body>;
  detail::run_blocks(
      num_blocks, threads, const_cast<Callable*>(std::addressof(body)),
      [](void* context, Index block) { (*static_cast<std::remove_reference_t<Body>*>(context))(block); });
}

/// The sum of `terms`, always in their order, so that it has the same bits however they were made.
[[nodiscard]] double ordered_sum(std::span<const double> terms) noexcept;

}  // namespace scree
