#pragma once

#include <scree/error.hpp>
#include <scree/transport/components.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <string_view>
#include <type_traits>
#include <utility>

namespace scree::transport {

namespace detail {

/// A flux of one number: double(double u, normal).
template <class F, int D>
concept ScalarFlux = std::is_invocable_r_v < double,
        const F&, double, const Vector<D>
& > ;

/// A bound of speeds between two numbers: double(double left, double right, normal).
template <class F, int D>
concept ScalarSpeed = std::is_invocable_r_v < double,
        const F&, double, double, const Vector<D>
& > ;

}  // namespace detail

/// How a wave speed is sampled.
struct Sampling {
  int num_samples = 16;         ///< parts that an interval is cut into: the flux is called once more
  double smallest_step = 1e-6;  ///< shortest interval that is sampled [unit of the state]
  double lowest = -std::numeric_limits<double>::infinity();  ///< state below which there is no flux
  double highest = std::numeric_limits<double>::infinity();  ///< state above which there is none
};

/// The wave speed of a scalar flux between two states, from samples: the largest slope of the flux over a
/// part of the interval, and as much more as the slope changes at most from one part to the next.
///
/// **Not a proven bound**: a spike between two samples is missed. Its error is of second order in the length
/// of the parts where the flux is smooth. It calls the flux once more than there are parts, at each face.
/// @see Eq. (T21)
template <int D, detail::ScalarFlux<D> FluxFunction>
class SampledSpeed {
 public:
  static constexpr std::string_view warning =
      "the wave speed is sampled from the flux: a spike between two samples is missed, and with it stability";

  /// @param flux of a number along a unit normal.
  /// @throws InputError if there are fewer than two samples, or the smallest step is not positive, or the
  /// states it lies between are not further apart.
  explicit SampledSpeed(FluxFunction flux, const Sampling& sampling = {})
      : flux_{std::move(flux)}, sampling_{sampling} {
    require(sampling.num_samples >= 2, "SampledSpeed: two samples are the fewest");
    require(sampling.smallest_step > 0 && std::isfinite(sampling.smallest_step),
            "SampledSpeed: the smallest step must be positive and finite");
    require(sampling.highest - sampling.lowest > sampling.smallest_step,
            "SampledSpeed: the highest state must exceed the lowest by more than the smallest step");
  }

  [[nodiscard]] double operator()(double left, double right, const Vector<D>& normal) const noexcept {
    const Interval interval = sampled(left, right);
    const double part = interval.length / sampling_.num_samples;
    double steepest = 0;
    double change = 0;
    double flux = flux_(interval.low, normal);
    double slope = 0;
    for (int i = 1; i <= sampling_.num_samples; ++i) {
      const double next_flux = flux_(interval.low + i * part, normal);
      const double next_slope = (next_flux - flux) / part;
      if (i > 1) change = larger(change, std::abs(next_slope - slope));
      steepest = larger(steepest, std::abs(next_slope));
      slope = next_slope;
      flux = next_flux;
    }
    return steepest + change;
  }

 private:
  struct Interval {
    double low;
    double length;
  };

  /// The interval between two states, made long enough for differences, inside what has a flux.
  [[nodiscard]] Interval sampled(double left, double right) const noexcept {
    const double length = std::max(std::abs(right - left), sampling_.smallest_step);
    const double low = 0.5 * (left + right) - 0.5 * length;
    return {std::max(std::min(low, sampling_.highest - length), sampling_.lowest), length};
  }

  FluxFunction flux_;
  Sampling sampling_;
};

}  // namespace scree::transport
