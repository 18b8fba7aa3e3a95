#include "transfer_loops.hpp"

namespace scree::mpm::SCREE_INSTRUCTION_SET {

template TransferKernels<2, 2> transfer_kernels<2, 2>(std::size_t, std::size_t) noexcept;
template TransferKernels<2, 3> transfer_kernels<2, 3>(std::size_t, std::size_t) noexcept;

}  // namespace scree::mpm::SCREE_INSTRUCTION_SET
