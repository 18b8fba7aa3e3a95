#pragma once

#include <scree/error.hpp>
#include <scree/transport/concepts.hpp>

#include <cmath>

namespace scree::transport {

/// Venkatakrishnan's limiter: smooth, and blind to variations below epsilon = scale (K h/length)^(3/2), so
/// that smooth extrema are not clipped.
///
/// Bounds are kept only up to epsilon/(2 sqrt 2) per face value: K > 0 gives the strict maximum principle
/// away. K = 0, the default, keeps it. One scale serves all components: for components of different size
/// another limiter is better.
/// @see Eq. (T33b), \cite venkatakrishnan1995
class Venkatakrishnan {
 public:
  static constexpr std::string_view name = "venkatakrishnan";
  static constexpr std::string_view summary = "smooth; with K > 0 it spares smooth extrema and breaks bounds";
  static constexpr bool keeps_bounds = true;  ///< as far as epsilon says

  /// @param K how much is left alone, 0.3 to 5 as a rule [-], zero or more
  /// @param scale typical variation of the solution [unit of the state], positive
  /// @param length typical length of the domain [m], positive
  /// @throws InputError
  explicit Venkatakrishnan(double K = 0, double scale = 1, double length = 1)
      : K_{K}, scale_{scale}, length_{length} {
    require(K >= 0 && std::isfinite(K), "Venkatakrishnan: K must be zero or positive, and finite");
    require(scale > 0 && std::isfinite(scale), "Venkatakrishnan: the scale must be positive and finite");
    require(length > 0 && std::isfinite(length), "Venkatakrishnan: the length must be positive and finite");
  }

  /// Variations of a cell of this width that are left alone [unit of the state].
  [[nodiscard]] double epsilon(double width) const noexcept {
    const double ratio = K_ * width / length_;
    return scale_ * ratio * std::sqrt(ratio);
  }

  [[nodiscard]] double operator()(double allowed, double wanted, double width) const noexcept {
    const double epsilon_here = epsilon(width);
    const double common = allowed * allowed + epsilon_here * epsilon_here;
    const double factor = (common + 2 * wanted * allowed) / (common + wanted * (2 * wanted + allowed));
    return 2 * wanted > allowed ? factor : 1.0;
  }

 private:
  double K_;
  double scale_;
  double length_;
};
static_assert(CellLimiter<Venkatakrishnan>);

}  // namespace scree::transport
