#pragma once

#include <scree/input_column.hpp>
#include <scree/tensor.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
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
  /// What is left of the law's own equations, relative to their terms [-]: 0 where they have been solved, as
  /// a closed form always has; else the step must not be taken.
  Real unsolved{};
};

/// A column that a law keeps: one number of its memory.
struct StateColumn {
  std::string_view name;
  std::string_view unit;  ///< SI; "-" if it has none
  double initial = 0;     ///< its value in material that has not been deformed yet [unit]
  /// What a person may begin with instead [unit]; nothing where only `initial` makes sense, as of a component
  /// of a tensor.
  std::optional<Interval> start = {};
};

/// What bounds an explicit step: the law's own speeds, viscosities and rates, at one point.
template <class Real>
struct Stiffness {
  Real wave_speed;  ///< of pressure waves [m/s]
  Real viscosity;   ///< effective dynamic viscosity [Pa s]
  /// Fastest rate at which the law's memory changes without being solved for [1/s]: the step that the law
  /// suggests is its inverse.
  Real relaxation_rate{};
};

/// The contract of mpm (which calls) and rheology (which supplies): a value type of parameters with a pure
/// update of one point: the old state is never changed, so a step can be tried and taken back. `Input` and
/// `State` are aggregates of Real, empty if there is nothing to read or to remember; `inputs` and `states`
/// describe their members in order, a column each. An update over no time (dt = 0) gives the stress that the
/// state already has.
template <class Law>
concept ConstitutiveLaw = std::is_trivially_copyable_v<Law> &&
    requires(const Law law, const Deformation<double>& deformation,
             const typename Law::template Input<double>& input,
             const typename Law::template State<double>& state, double dt) {
  { Law::name } -> std::convertible_to<std::string_view>;
  { Law::inputs.size() } -> std::convertible_to<std::size_t>;
  { Law::states.size() } -> std::convertible_to<std::size_t>;
  { law.update(deformation, input, state, dt) }
  noexcept->std::same_as<Response<double, typename Law::template State<double>>>;
  { law.stiffness(deformation, input, state) }
  noexcept->std::same_as<Stiffness<double>>;
};

/// A law whose update is an elastic predictor, its memory if all of the step is elastic, and a corrector,
/// what flow leaves of it: `update` is `correct` of what `predict` says, of a `PlaneState` too if the law has
/// one. A block of points is first predicted, then corrected: two short chains of operations, of which more
/// points are under way at once than of a long one.
template <class Law>
concept PredictsAndCorrects = ConstitutiveLaw<Law> &&
    requires(const Law law, const Deformation<double>& deformation,
             const typename Law::template Input<double>& input,
             const typename Law::template State<double>& state, double dt) {
  { law.predict(deformation, state, dt) }
  noexcept->std::same_as<typename Law::template State<double>>;
  { law.correct(deformation, input, state, dt) }
  noexcept->std::same_as<Response<double, typename Law::template State<double>>>;
};

/// A law with a form for plane flow that is faster, where components of its memory are and stay 0: it updates
/// a `PlaneState` too, an aggregate of the others, and `plane_states` says which of the `states` they are.
/// The rest are neither read nor written then.
template <class Law>
concept HasPlaneForm = ConstitutiveLaw<Law> &&
    requires(const Law law, const Deformation<double>& deformation,
             const typename Law::template Input<double>& input,
             const typename Law::template PlaneState<double>& state, double dt) {
  { Law::plane_states.size() } -> std::convertible_to<std::size_t>;
  { law.update(deformation, input, state, dt) }
  noexcept->std::same_as<Response<double, typename Law::template PlaneState<double>>>;
  { law.stiffness(deformation, input, state) }
  noexcept->std::same_as<Stiffness<double>>;
};

}  // namespace scree
