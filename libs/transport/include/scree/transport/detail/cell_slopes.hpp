#pragma once

#include <scree/transport/cell_states.hpp>
#include <scree/transport/concepts.hpp>
#include <scree/transport/detail/patch.hpp>
#include <scree/transport/reconstructions/cell_gradient.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace scree::transport::detail {

/// A gradient: the derivatives of all components along each axis [unit of the state / m].
template <int D, int N>
using Gradient = std::array<Vector<N>, static_cast<std::size_t>(D)>;

/// gradient . offset.
template <int D, int N>
[[nodiscard]] Vector<N> change_along(const Gradient<D, N>& gradient, const Vector<D>& offset) noexcept {
  Vector<N> change = offset[0] * gradient[0];
  for (int d = 1; d < D; ++d) change += offset[d] * gradient[static_cast<std::size_t>(d)];
  return change;
}

/// The values of a cell, as a vector that the compiler can add at once.
template <int N>
[[nodiscard]] Eigen::Map<const Vector<N>> values_of(const CellStates<N>& fields, Index cell) noexcept {
  return Eigen::Map<const Vector<N>>{fields.data() + cell * N};
}
template <int N>
[[nodiscard]] Eigen::Map<Vector<N>> values_of(CellStates<N>& fields, Index cell) noexcept {
  return Eigen::Map<Vector<N>>{fields.data() + cell * N};
}

/// What the neighbours of some cells allow and what the gradients want; differences to the cell's own value,
/// component k of cell i at [i * N + k].
template <int N>
struct SlopeBounds {
  static constexpr Index num_cells = 64;  // whole packs for any N
  using Values = std::array<double, static_cast<std::size_t>(num_cells* N)>;

  alignas(64) Values lowest;   ///< of the neighbours, <= 0
  alignas(64) Values highest;  ///< of the neighbours, >= 0
  alignas(64) Values down;     ///< lowest that the gradient reaches at a face, <= 0
  alignas(64) Values up;       ///< highest
  alignas(64) Values width;    ///< of the cell [m]
  alignas(64) Values factor;   ///< what the limiter makes of it [-]
};

/// What the cells around tell a cell.
template <int D, int N>
struct Fit {
  Gradient<D, N> gradient;
  Vector<N> lowest;   ///< of the differences to them, <= 0
  Vector<N> highest;  ///< >= 0
};

/// By least squares.  Eq. (T32a)
template <int D, int N>
[[nodiscard]] inline Fit<D, N> fit(const Patch<D>& patch, const CellStates<N>& states, Index cell) noexcept {
  const Vector<N> here = values_of<N>(states, cell);
  Fit<D, N> result{{}, Vector<N>::Zero(), Vector<N>::Zero()};
  Gradient<D, N> sum;
  sum.fill(Vector<N>::Zero());
  for (const StencilCell<D>& near : patch.stencil_of(cell)) {
    const Vector<N> difference = values_of<N>(states, near.cell) - here;
    result.lowest = result.lowest.cwiseMin(difference);
    result.highest = result.highest.cwiseMax(difference);
    for (std::size_t d = 0; d < D; ++d) sum[d] += static_cast<double>(near.weight[d]) * difference;
  }
  const Matrix<D>& correction = patch.corrections.data()[cell];
  for (int d = 0; d < D; ++d) {
    result.gradient[static_cast<std::size_t>(d)] = change_along<D, N>(sum, correction.row(d).transpose());
  }
  return result;
}

/// The changes from a cell's centre to its sides by its gradient, into `changes`, and their bounds and those
/// of its neighbours: entry `i` of `bounds`.
template <int D, int N>
inline void find_changes(const Patch<D>& patch, const CellStates<N>& states, Index cell, Index i,
                         CellStates<N>& changes, SlopeBounds<N>& bounds) noexcept {
  const auto store = [&](auto& values, const Vector<N>& value) {
    Eigen::Map<Vector<N>>{values.data() + i* N} = value;
  };
  const Fit<D, N> found = fit<D, N>(patch, states, cell);
  Vector<N> down = Vector<N>::Zero();
  Vector<N> up = Vector<N>::Zero();
  const Index end = patch.first_side.data()[cell + 1];
  const Vector<D>* offsets = patch.offsets.data();
  double* target = changes.data();
  for (Index side = patch.first_side.data()[cell]; side < end; ++side) {
    const Vector<N> change = change_along<D, N>(found.gradient, offsets[side]);
    down = down.cwiseMin(change);
    up = up.cwiseMax(change);
    Eigen::Map<Vector<N>>{target + side* N} = change;
  }
  store(bounds.lowest, found.lowest);
  store(bounds.highest, found.highest);
  store(bounds.down, down);
  store(bounds.up, up);
  store(bounds.width, Vector<N>::Constant(patch.widths.data()[cell]));
}

/// The limiter's factors of `count` values, whole packs.  Eq. (T33)
template <class L, int N>
[[gnu::noinline, gnu::flatten]] void limit(const L& limiter, SlopeBounds<N>& bounds, Index count) noexcept {
  const double* lowest = bounds.lowest.data();
  const double* highest = bounds.highest.data();
  const double* down = bounds.down.data();
  const double* up = bounds.up.data();
  const double* width = bounds.width.data();
  double* factor = bounds.factor.data();
#pragma GCC ivdep
  for (Index i = 0; i < count; ++i) {
    const double rising = limiter(highest[i], up[i], width[i]);
    const double falling = limiter(-lowest[i], -down[i], width[i]);
    factor[i] = rising < falling ? rising : falling;
  }
}

/// The smallest factor of a cell's components. One that varies by no more than its noise asks for nothing.
template <int N>
[[nodiscard]] double common_factor(const SlopeBounds<N>& bounds, Index i, const Vector<N>& here,
                                   double scale) noexcept {
  double smallest = 1;
  for (int k = 0; k < N; ++k) {
    const auto entry = static_cast<std::size_t>(i * N + k);
    const double noise = 4 * round_off * std::max(std::abs(here[k]), scale);
    const bool is_signal = std::max(bounds.highest[entry], -bounds.lowest[entry]) > noise;
    smallest = is_signal ? std::min(smallest, bounds.factor[entry]) : smallest;
  }
  return smallest;
}

/// The factors of a cell's components.
template <class R, int N>
[[nodiscard]] Vector<N> factors(const R& reconstruction, const SlopeBounds<N>& bounds, Index i,
                                const Vector<N>& here) noexcept {
  if constexpr (R::is_common) {
    return Vector<N>::Constant(common_factor<N>(bounds, i, here, reconstruction.scale));
  } else {
    return Eigen::Map<const Vector<N>>{bounds.factor.data() + i * N};
  }
}

/// How many of the states at sides begin .. end - 1 a law cannot take.
template <class Law, int N>
[[nodiscard]] Index num_inadmissible(const Law& law, const CellStates<N>& values, Index begin,
                                     Index end) noexcept {
  Index result = 0;
  for (Index side = begin; side < end; ++side) result += law.is_admissible(values[side]) ? 0 : 1;
  return result;
}

/// Leaves cells first .. first + count - 1 without a slope where a law cannot take the state on a side.
template <class Law, int D, int N>
void flatten_inadmissible(const Law& law, const Patch<D>& patch, const CellStates<N>& states, Index first,
                          Index count, CellStates<N>& side_states) noexcept {
  const std::int32_t* first_side = patch.first_side.data();
  // All at once, on whole vectors: mostly there is nothing to do.
  if (num_inadmissible(law, side_states, first_side[first], first_side[first + count]) == 0) return;
  for (Index cell = first; cell < first + count; ++cell) {
    if (num_inadmissible(law, side_states, first_side[cell], first_side[cell + 1]) == 0) continue;
    for (Index side = first_side[cell]; side < first_side[cell + 1]; ++side) {
      values_of<N>(side_states, side) = values_of<N>(states, cell);
    }
  }
}

/// States on the sides of a patch's cells, from limited gradients; from none where a side would get a state
/// that cannot be.  Eqs. (T31), (T33)
template <class Law, class R, int D, int N>
[[gnu::noinline]] void find_side_states(const Patch<D>& patch, const Law& law, const R& reconstruction,
                                        const CellStates<N>& states, SlopeBounds<N>& bounds,
                                        CellStates<N>& result) noexcept {
  const std::int32_t* first_side = patch.first_side.data();
  double* sides = result.data();
  for (Index first = 0; first < patch.num_near; first += SlopeBounds<N>::num_cells) {
    const Index count = std::min(SlopeBounds<N>::num_cells, patch.num_near - first);
    for (Index i = 0; i < count; ++i) find_changes<D, N>(patch, states, first + i, i, result, bounds);
    limit(reconstruction.limiter, bounds, in_whole_packs(count * N));
    for (Index i = 0; i < count; ++i) {
      const Vector<N> here = values_of<N>(states, first + i);
      const Vector<N> factor = factors<R, N>(reconstruction, bounds, i, here);
      const Index end = first_side[first + i + 1];
      for (Index side = first_side[first + i]; side < end; ++side) {
        Eigen::Map<Vector<N>> value{sides + side * N};
        value = here + factor.cwiseProduct(value);
      }
    }
    if constexpr (HasAdmissibleStates<Law>) {
      flatten_inadmissible(law, patch, states, first, count, result);
    }
  }
}

}  // namespace scree::transport::detail
