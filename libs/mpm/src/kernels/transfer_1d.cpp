#include "transfer_loops.hpp"

namespace scree::mpm::SCREE_INSTRUCTION_SET {

template TransferKernels<1, 1> transfer_kernels<1, 1>(std::size_t, std::size_t) noexcept;
template TransferKernels<1, 2> transfer_kernels<1, 2>(std::size_t, std::size_t) noexcept;
template TransferKernels<1, 3> transfer_kernels<1, 3>(std::size_t, std::size_t) noexcept;

}  // namespace scree::mpm::SCREE_INSTRUCTION_SET
