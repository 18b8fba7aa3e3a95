#pragma once

#include <scree/transport/concepts.hpp>
#include <scree/transport/laws/sampled_speed.hpp>
#include <scree/transport/warning.hpp>

#include <array>
#include <type_traits>
#include <utility>

namespace scree::transport {

/// A conservation law of the user's own, from two functions: what make_law() returns.
///
/// Costs what a law written as a struct does: the functions are inlined into the loops.  Eq. (T1)
template <int N, int D, class FluxFunction, class SpeedFunction>
struct UserLaw : WarningOf<SpeedFunction> {
  static constexpr int num_components = N;
  using State = std::array<double, static_cast<std::size_t>(N)>;

  FluxFunction flux_function;
  SpeedFunction speed_function;

  UserLaw(FluxFunction of_flux, SpeedFunction of_speed)
      : flux_function{std::move(of_flux)}, speed_function{std::move(of_speed)} {}

  [[nodiscard]] State flux(const State& u, const Vector<D>& normal) const noexcept {
    if constexpr (detail::ScalarFlux<FluxFunction, D>) {
      static_assert(N == 1, "make_law: a flux of one number is for one component");
      return {flux_function(u[0], normal)};
    } else {
      return flux_function(u, normal);
    }
  }
  [[nodiscard]] double max_speed(const State& left, const State& right,
                                 const Vector<D>& normal) const noexcept {
    if constexpr (detail::ScalarSpeed<SpeedFunction, D>) {
      return speed_function(left[0], right[0], normal);
    } else {
      return speed_function(left, right, normal);
    }
  }
};

/// A law of N components in D dimensions from its flux and a bound of its wave speeds, both lambdas or
/// function objects:
/// ```cpp
/// const auto law = make_law<1, 2>(
///     [](double u, const Vector<2>& normal) { return (normal[0] + normal[1]) * u * u / 2; },
///     [](double left, double right, const Vector<2>& normal) {
///       return std::abs(normal[0] + normal[1]) * larger(std::abs(left), std::abs(right));
///     });
/// ```
/// Threads call them side by side; they must not throw, and pass on a NaN (see larger()). Generic lambdas
/// (`auto`) are not for this. A law with walls, primitive variables or diffusion is a struct: see Euler.
/// @param flux of a state along a unit normal. The state is a number, or std::array<double, N>, and so is
/// the result [unit of the state x m/s].
/// @param max_speed of two states and the normal: not less than |f'| for any state between both, which for a
/// flux that is not convex may be larger than at both ends [m/s].
/// @see Eqs. (T1), (T3)
template <int N, int D, class FluxFunction, class SpeedFunction>
[[nodiscard]] UserLaw<N, D, FluxFunction, SpeedFunction> make_law(FluxFunction flux,
                                                                  SpeedFunction max_speed) {
  using Made = UserLaw<N, D, FluxFunction, SpeedFunction>;
  static_assert(ConservationLaw<Made, D>);
  return {std::move(flux), std::move(max_speed)};
}

/// A scalar law whose wave speed is sampled from its flux: convenient, not proven, and slower.
/// @param flux of a number along a unit normal, as a number.
/// @see SampledSpeed, Eq. (T21)
template <int D, detail::ScalarFlux<D> FluxFunction>
[[nodiscard]] UserLaw<1, D, FluxFunction, SampledSpeed<D, FluxFunction>> make_law(
    FluxFunction flux, const Sampling& sampling = {}) {
  return {flux, SampledSpeed<D, FluxFunction>{flux, sampling}};
}

/// A law and bounds of its speeds to both sides, which make a central-upwind flux sharp.  Eq. (T16)
template <class Law, class RangeFunction>
struct WithSpeedRange : Law {
  RangeFunction range_function;

  WithSpeedRange(const Law& law, RangeFunction range) : Law{law}, range_function{std::move(range)} {}

  template <int D>
  [[nodiscard]] SpeedRange speed_range(const typename Law::State& left, const typename Law::State& right,
                                       const Vector<D>& normal) const noexcept {
    return range_function(left, right, normal);
  }
};

/// Adds to a law bounds of its wave speeds on both sides of zero.
/// @param range of two states and the normal, as a SpeedRange that holds for all states between.  Eq. (T16)
template <class Law, class RangeFunction>
[[nodiscard]] WithSpeedRange<Law, RangeFunction> with_speed_range(const Law& law, RangeFunction range) {
  return {law, std::move(range)};
}

/// A law and a source.  Eq. (T1)
template <class Law, class SourceFunction>
struct WithSource : Law {
  SourceFunction source_function;

  WithSource(const Law& law, SourceFunction source) : Law{law}, source_function{std::move(source)} {}

  template <int D>
  [[nodiscard]] typename Law::State source(const typename Law::State& u, const Vector<D>& position,
                                           double time) const noexcept {
    return source_function(u, position, time);
  }
};

/// Adds a source to any law, one of the library too.
/// @param source of the state, the position [m] and the time [s], as a state [unit of the state / s].
template <class Law, class SourceFunction>
[[nodiscard]] WithSource<Law, SourceFunction> with_source(const Law& law, SourceFunction source) {
  return {law, std::move(source)};
}

}  // namespace scree::transport
