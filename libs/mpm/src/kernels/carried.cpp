#include "carried_loops.hpp"

namespace scree::mpm::SCREE_INSTRUCTION_SET {

template CarriedKernels<1> carried_kernels<1>(Sites, std::size_t) noexcept;
template CarriedKernels<2> carried_kernels<2>(Sites, std::size_t) noexcept;
template CarriedKernels<3> carried_kernels<3>(Sites, std::size_t) noexcept;

}  // namespace scree::mpm::SCREE_INSTRUCTION_SET
