#pragma once

#include <scree/law_block.hpp>

#include <typeinfo>

namespace scree::rheology {

namespace detail {
/// A BlockKernel of any law.
using AnyKernel = void (*)();
/// The kernel of the law of this type, null if it is not in the list.
[[nodiscard]] AnyKernel any_block_kernel(const std::type_info& law, InstructionSet set) noexcept;
}  // namespace detail

/// The fastest kernel of a law of the list (`AnyLaw`) that an instruction set can run, which must run here:
/// that of a narrower set where wide registers do not pay. Null for any other type.
template <class Law>
[[nodiscard]] BlockKernel<Law> block_kernel(const Law& /*law*/, InstructionSet set) noexcept {
  return reinterpret_cast<BlockKernel<Law>>(detail::any_block_kernel(typeid(Law), set));
}

}  // namespace scree::rheology
