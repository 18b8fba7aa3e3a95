#pragma once

#include <scree/transport/cell_limiters/smooth_cubic.hpp>
#include <scree/transport/concepts.hpp>

#include <concepts>

namespace scree::transport {

/// A gradient in each cell: which limiter, how far around the cell it looks, and whether all components
/// share one factor.
template <class R>
concept CellReconstruction = Named<R> && std::copyable<R> && CellLimiter<decltype(R::limiter)> &&
    requires(const R reconstruction) {
  { R::is_common } -> std::convertible_to<bool>;
  { reconstruction.rings } -> std::convertible_to<int>;
  { reconstruction.promised_cfl() }
  noexcept->std::same_as<double>;
};

/// Second order on any grid: a gradient in each cell, by least squares from the cells around, each
/// component's limited by itself. Linear fields are kept whole by Unlimited, by the others as far as the
/// values at the faces lie well within the neighbours'.
///
/// Sums of components are not kept: for coupled fractions use CellGradientCommon.
/// @see Eqs. (T31) to (T34)
template <CellLimiter L>
struct CellGradient {
  static constexpr std::string_view name = "cell_gradient";
  static constexpr std::string_view summary = "second order on any grid: a gradient per cell, limited";
  static constexpr bool is_common = false;

  L limiter{};
  /// How far the cells lie that a gradient is made from and bounded by: 1 neighbours, 2 theirs too [-].
  /// With one, triangles are limited to first order: a linear field lies outside three neighbours' values.
  int rings = 2;

  /// On any cells, for any limiter that keeps bounds.  Eq. (T34)
  [[nodiscard]] double promised_cfl() const noexcept { return 0.5; }
};
template <CellLimiter L>
CellGradient(L) -> CellGradient<L>;
template <CellLimiter L>
CellGradient(L, int) -> CellGradient<L>;

/// The same with one factor for all components of a cell, the smallest that any of them asks for: fractions
/// that sum to one in the cells do so at the faces.
/// @see Eq. (T33)
template <CellLimiter L>
struct CellGradientCommon {
  static constexpr std::string_view name = "cell_gradient_common";
  static constexpr std::string_view summary =
      "a gradient per cell with one limiter factor for all components: keeps their sum";
  static constexpr bool is_common = true;

  L limiter{};
  int rings = 2;     ///< as in CellGradient
  double scale = 0;  ///< as in PiecewiseLinearCommon: variations below four round-offs of it ask for nothing

  [[nodiscard]] double promised_cfl() const noexcept { return 0.5; }
};
template <CellLimiter L>
CellGradientCommon(L) -> CellGradientCommon<L>;
template <CellLimiter L>
CellGradientCommon(L, int, double) -> CellGradientCommon<L>;

static_assert(CellReconstruction<CellGradient<SmoothCubic>> &&
              CellReconstruction<CellGradientCommon<SmoothCubic>>);

}  // namespace scree::transport
