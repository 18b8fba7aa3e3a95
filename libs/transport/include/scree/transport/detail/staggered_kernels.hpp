#pragma once

#include <scree/transport/components.hpp>
#include <scree/transport/concepts.hpp>
#include <scree/transport/detail/pieces.hpp>
#include <scree/transport/detail/tiles.hpp>

#include <array>

// The loops over sites of a staggered step, along rows of up to tile_width. As in row_kernels.hpp each is one
// function that is never inlined into a caller and has everything inlined into it.

namespace scree::transport::detail {

/// First of `count` consecutive sites, and of their neighbours on both sides along an axis.
struct LineRow {
  Index below;
  Index here;
  Index above;
  Index count;
};

/// Along one axis: slopes of the states to `passed`, and what the slopes of their fluxes change in half a
/// step to `half`.  Eq. (T42)
template <int D, class Law, class L, int N>
[[gnu::noinline, gnu::flatten]] void add_slopes(const Law& law, const L& limiter, const Fields<N>& fields,
                                                const LineRow& row, int axis, double dt_per_width,
                                                double* __restrict half, double* __restrict passed,
                                                Index passed_stride) noexcept {
  using State = std::array<double, static_cast<std::size_t>(N)>;
  const Vector<D> normal = Vector<D>::Unit(axis);
  const Index stride = fields.stride();
  const double* u = fields.data();
#pragma GCC ivdep
  for (Index i = 0; i < row.count; ++i) {
    State below;
    State here;
    State above;
    for_each_component<N>([&](std::size_t k) {
      const double* component = u + static_cast<Index>(k) * stride;
      below[k] = component[row.below + i];
      here[k] = component[row.here + i];
      above[k] = component[row.above + i];
    });
    const State flux_below = law.flux(below, normal);
    const State flux_here = law.flux(here, normal);
    const State flux_above = law.flux(above, normal);
    for_each_component<N>([&](std::size_t k) {
      const auto c = static_cast<Index>(k);
      const double flux_slope = limiter(flux_here[k] - flux_below[k], flux_above[k] - flux_here[k]);
      half[c * Tile<N>::stride + i] -= 0.5 * dt_per_width * flux_slope;
      passed[c * passed_stride + i] = 0.25 * limiter(here[k] - below[k], above[k] - here[k]);
    });
  }
}

/// Adds the fluxes at half time along one axis to what is passed on.  Eq. (T43)
template <int D, class Law, int N>
[[gnu::noinline, gnu::flatten]] void add_fluxes(const Law& law, const Tile<N>& half, Index count, int axis,
                                                double dt_per_width, double* __restrict passed,
                                                Index passed_stride) noexcept {
  using State = std::array<double, static_cast<std::size_t>(N)>;
  const Vector<D> normal = Vector<D>::Unit(axis);
#pragma GCC ivdep
  for (Index i = 0; i < count; ++i) {
    State u;
    for_each_component<N>([&](std::size_t k) { u[k] = half.row(static_cast<int>(k))[i]; });
    const State flux = law.flux(u, normal);
    for_each_component<N>([&](std::size_t k) {
      passed[static_cast<Index>(k) * passed_stride + i] += 2 * dt_per_width * flux[k];
    });
  }
}

/// The largest wave speeds between each site of a row and its neighbour above along an axis [m/s].
template <int D, class Law, int N>
[[gnu::noinline, gnu::flatten]] void speeds_above(const Law& law, const Fields<N>& fields, const LineRow& row,
                                                  int axis, double* __restrict speed) noexcept {
  using State = std::array<double, static_cast<std::size_t>(N)>;
  const Vector<D> normal = Vector<D>::Unit(axis);
  const Index stride = fields.stride();
  const double* u = fields.data();
#pragma GCC ivdep
  for (Index i = 0; i < row.count; ++i) {
    State here;
    State above;
    for_each_component<N>([&](std::size_t k) {
      here[k] = u[static_cast<Index>(k) * stride + row.here + i];
      above[k] = u[static_cast<Index>(k) * stride + row.above + i];
    });
    speed[i] = law.max_speed(here, above, normal);
  }
}

/// New states of up to tile_width sites in a row, from the pieces round them, the first of which is `entry`.
/// Eq. (T43)
template <int D, int N>
[[gnu::noinline]] void join(const Pieces<D, N>& pieces, Index entry, Index count, double* target,
                            Index target_stride) noexcept {
  constexpr int num_rows = 1 << (D - 1);  // of pieces beside the target's
  constexpr double share = 1.0 / (2 * num_rows);
  for (int k = 0; k < N; ++k) {
    double* __restrict result = target + k * target_stride;
    for (Index i = 0; i < count; ++i) result[i] = 0;
    for (int row = 0; row < num_rows; ++row) {
      Index first = entry;
      std::array<double, D>
          sign{};  // of what is passed on across the rows: up from the low row, down from the high
      for (int axis = 1; axis < D; ++axis) {
        const bool is_high = ((row >> (axis - 1)) & 1) != 0;
        sign[static_cast<std::size_t>(axis)] = is_high ? -share : share;
        if (is_high) first += pieces.stride(axis);
      }
      const double* u = pieces.state(k) + first;
      const double* along = pieces.passed(0, k) + first;
      for (Index i = 0; i < count; ++i) {
        result[i] += share * ((u[i] + u[i + 1]) + (along[i] - along[i + 1]));
      }
      for (int axis = 1; axis < D; ++axis) {
        const double factor = sign[static_cast<std::size_t>(axis)];
        const double* across = pieces.passed(axis, k) + first;
        for (Index i = 0; i < count; ++i) result[i] += factor * (across[i] + across[i + 1]);
      }
    }
  }
}

}  // namespace scree::transport::detail
