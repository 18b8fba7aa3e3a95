#pragma once

#include <experimental/simd>

namespace scree::testing {

/// N doubles that are computed with at once, in as few registers as the instruction set that is compiled for
/// has.
template <int N>
using Pack = std::experimental::simd<double, std::experimental::simd_abi::deduce_t<double, N>>;

}  // namespace scree::testing
