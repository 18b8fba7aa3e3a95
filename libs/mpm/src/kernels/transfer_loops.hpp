#pragma once

#include "gather_loops.hpp"
#include "scatter_loops.hpp"
#include "transfer_kernels.hpp"

#include <cstddef>
#include <variant>

namespace scree::mpm::SCREE_INSTRUCTION_SET {

/// The kernels of every shape with every rule.
template <int D, int V, class Shapes, class Rules>
struct KernelTable;
template <int D, int V, class... S, class... R>
struct KernelTable<D, V, std::variant<S...>, std::variant<R...>> {
  using Entry = TransferKernels<D, V>;
  template <class One>
  struct Row {
    static constexpr Entry entries[] = {{scatter<D, V, One, R>, gather<D, V, One, R>}...};
  };
  static constexpr const Entry* rows[] = {Row<S>::entries...};
};

template <int D, int V>
TransferKernels<D, V> transfer_kernels(std::size_t shape, std::size_t rule) noexcept {
  return KernelTable<D, V, AnyShape, AnyTransfer>::rows[shape][rule];
}

}  // namespace scree::mpm::SCREE_INSTRUCTION_SET
