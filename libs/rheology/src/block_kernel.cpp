#include "block_kernels.hpp"

namespace scree::rheology::detail {

AnyKernel any_block_kernel(const std::type_info& law, InstructionSet set) noexcept {
  AnyKernel kernel = nullptr;
#ifdef SCREE_WIDE_KERNELS
  if (set == InstructionSet::x86_64_v4) kernel = x86_64_v4::any_block_kernel(law);
  if (kernel == nullptr && set != InstructionSet::baseline) kernel = x86_64_v3::any_block_kernel(law);
#else
  static_cast<void>(set);
#endif
  return kernel != nullptr ? kernel : baseline::any_block_kernel(law);
}

}  // namespace scree::rheology::detail
