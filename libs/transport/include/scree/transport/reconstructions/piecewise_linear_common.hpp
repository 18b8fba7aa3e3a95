#pragma once

#include <scree/transport/components.hpp>
#include <scree/transport/concepts.hpp>
#include <scree/transport/limiters/minmod.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace scree::transport {

/// Second order with one limiter factor for all components of a cell: each slope is alpha times the
/// central difference, alpha in [0, 1] the smallest that any component's limiter asks for.
///
/// The slopes of components whose sum is constant add to zero, so fractions that sum to one do so at the
/// faces too. Linear profiles are kept whole.
/// @see Eq. (T6)
template <Limiter L>
struct PiecewiseLinearCommon {
  static constexpr std::string_view name = "piecewise_linear_common";
  static constexpr std::string_view summary =
      "second order with one limiter factor for all components: keeps their sum";

  L limiter{};
  /// Typical size of a component [unit of the state]: variations below four round-offs of it, or of the
  /// cell's value, ask for nothing. Fractions take 1: else the last digits of classes that are all but absent
  /// flatten the profiles of the others. Bounds hold to those round-offs.
  double scale = 0;

  template <class State>
  [[nodiscard]] Edges<State> operator()(const State& below, const State& here,
                                        const State& above) const noexcept {
    constexpr int num_components = static_cast<int>(std::tuple_size_v<State>);
    Ratio alpha{1, 1};
    for_each_component<num_components>([&](std::size_t k) {
      alpha = smaller(alpha, here[k] - below[k], above[k] - here[k], noise_of(here[k]));
    });
    const double quarter = 0.25 * (alpha.numerator / alpha.denominator);
    Edges<State> edges;
    for_each_component<num_components>([&](std::size_t k) {
      const double half_slope = quarter * (above[k] - below[k]);
      edges.low[k] = here[k] - half_slope;
      edges.high[k] = here[k] + half_slope;
    });
    return edges;
  }

  /// Coupled components keep their bounds up to 1/2, whatever the limiter.  Eq. (T9)
  [[nodiscard]] double promised_cfl() const noexcept { return 0.5; }

  /// Differences of a component that are rounding only.
  [[nodiscard]] double noise_of(double here) const noexcept {
    return 4 * round_off * std::max(std::abs(here), scale);
  }

 private:
  /// Not divided until the smallest is known.
  struct Ratio {
    double numerator;
    double denominator;
  };

  /// The smaller of `alpha` and the part of the central difference that the limiter allows a component. One
  /// that varies by no more than its noise asks for nothing: it must not flatten the others.
  [[nodiscard]] Ratio smaller(const Ratio& alpha, double backward, double forward,
                              double noise) const noexcept {
    const double central = std::abs(0.5 * (backward + forward));
    const double limited = std::abs(limiter(backward, forward));
    const bool is_signal = std::max(std::abs(backward), std::abs(forward)) > noise;
    const bool is_smaller = limited * alpha.denominator < alpha.numerator * central;
    const bool is_taken = is_signal & is_smaller;
    return {is_taken ? limited : alpha.numerator, is_taken ? central : alpha.denominator};
  }
};
template <Limiter L>
PiecewiseLinearCommon(L) -> PiecewiseLinearCommon<L>;
template <Limiter L>
PiecewiseLinearCommon(L, double) -> PiecewiseLinearCommon<L>;

static_assert(Reconstruction<PiecewiseLinearCommon<Minmod>, 2>);

}  // namespace scree::transport
