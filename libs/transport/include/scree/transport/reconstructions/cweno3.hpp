#pragma once

#include <scree/error.hpp>
#include <scree/transport/components.hpp>
#include <scree/transport/concepts.hpp>

#include <cmath>
#include <tuple>

namespace scree::transport {

/// Third order where the data are smooth: a parabola per cell, a weighted mean of the lines to both sides and
/// of a central parabola; beside a jump the weight goes to the line that does not cross it.
///
/// Not TVD: it leaves the bounds by up to a thousandth of a jump. For smooth fields in 1D, or linear fluxes,
/// with SspRk3; each component by itself. Cells of equal width only.
/// @see Eq. (T40), \cite kurganovlevy2000
class Cweno3 {
 public:
  static constexpr std::string_view name = "cweno3";
  static constexpr std::string_view summary =
      "third order where smooth: weighted parabolas; not TVD, cells of equal width only";
  static constexpr bool needs_equal_cells = true;
  static constexpr bool leaves_bounds = true;

  /// @param scale typical size of a component [its unit]: differences far below a thousandth of it count as
  /// smooth. Too small costs order at extrema, too large lets jumps ring; with unlike components take the
  /// smallest.  @throws InputError if it is not positive and finite.
  explicit Cweno3(double scale = 1) : rough_per_square_{1 / (relative_smoothness * scale * scale)} {
    require(scale > 0 && 0 < rough_per_square_ && std::isfinite(rough_per_square_),
            "Cweno3: the scale must be positive and finite");
  }

  template <class State>
  [[nodiscard]] Edges<State> operator()(const State& below, const State& here,
                                        const State& above) const noexcept {
    Edges<State> edges;
    for_each_component<static_cast<int>(std::tuple_size_v<State>)>([&](std::size_t k) {
      const double backward = here[k] - below[k];
      const double forward = above[k] - here[k];
      const double bend = forward - backward;
      const double middle = (backward + forward) / 2;
      const double weight_below = share(0.25, backward * backward);
      const double weight_above = share(0.25, forward * forward);
      const double weight_here = share(0.5, 13.0 / 3 * bend * bend + middle * middle);
      const double whole = 1 / (weight_below + weight_here + weight_above);
      const double slope = weight_below * backward + weight_here * middle + weight_above * forward;
      const double even = here[k] + whole * weight_here * bend / 6;
      edges.low[k] = even - whole * slope / 2;
      edges.high[k] = even + whole * slope / 2;
    });
    return edges;
  }

  /// Linear stability with SspRk3 for whatever weights, and no bounds.  Eq. (T41)
  [[nodiscard]] double promised_cfl() const noexcept { return 0.5; }

 private:
  static constexpr double relative_smoothness = 1e-6;  // [-] the paper's epsilon

  [[nodiscard]] double share(double ideal, double square) const noexcept {
    const double distance = 1 + rough_per_square_ * square;
    return ideal / (distance * distance);
  }

  double rough_per_square_;  // [1/(unit of the state)^2]
};
static_assert(Reconstruction<Cweno3, 1>);

}  // namespace scree::transport
