#pragma once

#include <scree/rheology/eigen_symmetric.hpp>
#include <scree/rheology/elementary.hpp>
#include <scree/rheology/kinematics.hpp>
#include <scree/rheology/plane_functions.hpp>
#include <scree/rheology/tensor_functions.hpp>

#include <array>

namespace scree::rheology {

/// A logarithmic (Hencky) strain at constant volume, along its own axes.
template <class Real>
struct HenckyStrain {
  std::array<Real, 3> values;  ///< of sum zero [-]
  Tensor<Real> axes;           ///< column j belongs to `values[j]`
};

/// dev(ln b)/2 of a left Cauchy-Green tensor b.  Eq. (R23)
template <class Real>
[[nodiscard]] HenckyStrain<Real> hencky_strain(const EigenSystem<Real>& b) noexcept {
  HenckyStrain<Real> result{{}, b.vectors};
  for (std::size_t i = 0; i < 3; ++i) result.values[i] = 0.5 * elementary::log(b.values[i]);
  const Real mean = (result.values[0] + result.values[1] + result.values[2]) * (1.0 / 3.0);
  for (Real& e : result.values) e = e - mean;
  return result;
}

/// b = exp(2 strain).  Eq. (R23)
template <class Real>
[[nodiscard]] Symmetric<Real> left_cauchy_green(const HenckyStrain<Real>& strain) noexcept {
  std::array<Real, 3> stretch{};
  for (std::size_t i = 0; i < 3; ++i) stretch[i] = elementary::exp(2.0 * strain.values[i]);
  return symmetric(composed(stretch, strain.axes));
}

/// dev(ln b)/2 of a left Cauchy-Green tensor b, for a law that needs none of its axes.  Eq. (R23)
/// @tparam Form Symmetric, or PlaneSymmetric
template <class Real, template <class> class Form>
[[nodiscard]] Form<Real> hencky_strain(const Form<Real>& b) noexcept {
  return deviator(half_logarithm(b));
}

/// b = exp(2 strain).  Eq. (R23)
/// @tparam Form Symmetric, or PlaneSymmetric
template <class Real, template <class> class Form>
[[nodiscard]] Form<Real> left_cauchy_green(const Form<Real>& strain) noexcept {
  return exponential(Real(2.0) * strain);
}

}  // namespace scree::rheology
