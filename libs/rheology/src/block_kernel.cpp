#include "block_kernels.hpp"

namespace scree::rheology::detail {

AnyKernel any_block_kernel(const std::type_info& law, InstructionSet set) noexcept {
  switch (set) {
#ifdef SCREE_WIDE_KERNELS
    case InstructionSet::x86_64_v3:
      return x86_64_v3::any_block_kernel(law);
    case InstructionSet::x86_64_v4:
      return x86_64_v4::any_block_kernel(law);
#endif
    default:
      return baseline::any_block_kernel(law);
  }
}

}  // namespace scree::rheology::detail
