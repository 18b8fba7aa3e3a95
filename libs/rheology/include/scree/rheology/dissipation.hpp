#pragma once

#include <scree/tensor.hpp>

namespace scree::rheology {

/// Power per volume that a stress spends on changing the shape, sigma' : D' [W/m^3]: what a law without
/// memory turns into heat; of a law with memory a part may be stored.  Eq. (R6)
/// @param stress Cauchy [Pa]  @param velocity_gradient L [1/s]
template <class Real>
[[nodiscard]] constexpr Real dissipation(const Tensor<Real>& stress,
                                         const Tensor<Real>& velocity_gradient) noexcept {
  return contract(deviator(stress), symmetric_part(velocity_gradient));
}

}  // namespace scree::rheology
