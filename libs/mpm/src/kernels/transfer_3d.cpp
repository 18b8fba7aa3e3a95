#include "transfer_loops.hpp"

namespace scree::mpm::SCREE_INSTRUCTION_SET {

template TransferKernels<3, 3> transfer_kernels<3, 3>(std::size_t, std::size_t) noexcept;

}  // namespace scree::mpm::SCREE_INSTRUCTION_SET
