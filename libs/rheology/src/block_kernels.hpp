#pragma once

#include <scree/rheology/block_kernel.hpp>

// The kernels of one instruction set, each compiled from block_kernels.cpp: null for a law that is not in the
// list. To be called on a machine that runs the set, and nowhere else.
namespace scree::rheology {

namespace baseline {
[[nodiscard]] detail::AnyKernel any_block_kernel(const std::type_info& law) noexcept;
}
namespace x86_64_v3 {
[[nodiscard]] detail::AnyKernel any_block_kernel(const std::type_info& law) noexcept;
}
namespace x86_64_v4 {
[[nodiscard]] detail::AnyKernel any_block_kernel(const std::type_info& law) noexcept;
}

}  // namespace scree::rheology
