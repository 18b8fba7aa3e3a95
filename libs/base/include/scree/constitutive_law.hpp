#pragma once

#include <scree/tensor.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <string_view>
#include <type_traits>

namespace scree {

/// What happens to a material point in one step.
template <class Real>
struct Deformation {
  Tensor<Real> velocity_gradient;  ///< L, L(i, j) = dv_i/dx_j [1/s]
  Real density;                    ///< at the end of the step [kg/m^3]
};

/// What a law answers.
template <class Real, class State>
struct Response {
  Tensor<Real> stress;  ///< Cauchy stress, tension positive [Pa]
  State state;          ///< the law's memory at the end of the step
};

/// What bounds an explicit step: the law's own speeds and viscosities, at one point.
struct Stiffness {
  double wave_speed;  ///< of pressure waves [m/s]
  double viscosity;   ///< effective dynamic viscosity [Pa s]
};

/// The contract of mpm (which calls) and rheology (which supplies): a value type of parameters with a pure
/// update of one point. `Input` and `State` are aggregates of Real, empty if there is nothing to read or to
/// remember; their names give the columns that are read and kept.
template <class Law>
concept ConstitutiveLaw = std::is_trivially_copyable_v<Law> &&
    requires(const Law law, const Deformation<double>& deformation,
             const typename Law::template Input<double>& input,
             const typename Law::template State<double>& state, double dt) {
  { Law::name } -> std::convertible_to<std::string_view>;
  { Law::input_names.size() } -> std::convertible_to<std::size_t>;
  { Law::state_names.size() } -> std::convertible_to<std::size_t>;
  { law.update(deformation, input, state, dt) }
  noexcept->std::same_as<Response<double, typename Law::template State<double>>>;
  { law.stiffness(deformation, input) }
  noexcept->std::same_as<Stiffness>;
};

}  // namespace scree
