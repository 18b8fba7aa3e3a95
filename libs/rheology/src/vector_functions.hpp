#pragma once

#include "block_kernels.hpp"

#include <scree/rheology/elementary.hpp>

#include <cstring>
#include <experimental/simd>

// The elementary functions of all lanes of a pack at once, from the vector library of glibc (libmvec), where
// there is one (cmake/scree_kernels.cmake): off by 4 units in the last place at most, by its manual, and by
// its scalar functions for whatever is not finite or not of the ordinary range. Each lane has bits that
// depend on its own number alone.

#ifdef SCREE_VECTOR_FUNCTIONS  // how their names begin for this instruction set

namespace scree::rheology::SCREE_INSTRUCTION_SET {

using Pack = std::experimental::simd<double, std::experimental::simd_abi::deduce_t<double, num_lanes>>;
using Register [[gnu::vector_size(num_lanes * sizeof(double))]] = double;

extern "C" {
[[gnu::const]] Register vector_exp(Register x) noexcept asm(SCREE_VECTOR_FUNCTIONS "v_exp");
[[gnu::const]] Register vector_expm1(Register x) noexcept asm(SCREE_VECTOR_FUNCTIONS "v_expm1");
[[gnu::const]] Register vector_log(Register x) noexcept asm(SCREE_VECTOR_FUNCTIONS "v_log");
[[gnu::const]] Register vector_pow(Register base, Register exponent) noexcept
    asm(SCREE_VECTOR_FUNCTIONS "vv_pow");
}

}  // namespace scree::rheology::SCREE_INSTRUCTION_SET

namespace scree::rheology::elementary {

template <>
struct Functions<SCREE_INSTRUCTION_SET::Pack> {
  using Pack = SCREE_INSTRUCTION_SET::Pack;
  using Register = SCREE_INSTRUCTION_SET::Register;

  [[nodiscard]] static Pack exp(const Pack& x) noexcept {
    return Pack{SCREE_INSTRUCTION_SET::vector_exp(static_cast<Register>(x))};
  }
  [[nodiscard]] static Pack expm1(const Pack& x) noexcept {
    return Pack{SCREE_INSTRUCTION_SET::vector_expm1(static_cast<Register>(x))};
  }
  [[nodiscard]] static Pack log(const Pack& x) noexcept {
    return Pack{SCREE_INSTRUCTION_SET::vector_log(static_cast<Register>(x))};
  }
  [[nodiscard]] static Pack pow(const Pack& base, const Pack& exponent) noexcept {
    return Pack{
        SCREE_INSTRUCTION_SET::vector_pow(static_cast<Register>(base), static_cast<Register>(exponent))};
  }
};

}  // namespace scree::rheology::elementary

#endif
