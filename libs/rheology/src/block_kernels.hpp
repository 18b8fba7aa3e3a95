#pragma once

#include <scree/rheology/block_kernel.hpp>

#include <cstddef>

// The kernels of one instruction set, each compiled from block_kernels.cpp: null for a law that is not in the
// list, or computes fewer points at once than the set's registers hold. To be called on a machine that runs
// the set, and nowhere else.
namespace scree::rheology {

namespace baseline {
inline constexpr std::size_t num_lanes = 1;  // what builds without optimisation compile too
[[nodiscard]] detail::AnyKernel any_block_kernel(const std::type_info& law) noexcept;
}  // namespace baseline
namespace x86_64_v3 {
inline constexpr std::size_t num_lanes = 4;
[[nodiscard]] detail::AnyKernel any_block_kernel(const std::type_info& law) noexcept;
}  // namespace x86_64_v3
namespace x86_64_v4 {
inline constexpr std::size_t num_lanes = 8;
[[nodiscard]] detail::AnyKernel any_block_kernel(const std::type_info& law) noexcept;
}  // namespace x86_64_v4

}  // namespace scree::rheology
