#pragma once

#include <scree/transport/cell_states.hpp>
#include <scree/transport/concepts.hpp>
#include <scree/transport/detail/face_tables.hpp>
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

/// What the neighbours of some cells allow and what the gradients want; differences to the cell's own value,
/// component k of cell i at [i * N + k].
template <int N>
struct SlopeBounds {
  static constexpr Index num_cells = 64;
  using Values = std::array<double, static_cast<std::size_t>(num_cells* N)>;

  alignas(64) Values lowest;   ///< of the neighbours, <= 0
  alignas(64) Values highest;  ///< of the neighbours, >= 0
  alignas(64) Values down;     ///< lowest that the gradient reaches at a face, <= 0
  alignas(64) Values up;       ///< highest
  alignas(64) Values width;    ///< of the cell [m]
  alignas(64) Values factor;   ///< what the limiter makes of it [-]
};

/// The least-squares gradient of a cell, its bounds, and how far it reaches at the faces: entry `i` of
/// `bounds`.  Eq. (T31)
template <int D, int N>
inline void find_gradient(const FaceTables<D>& tables, const CellStates<N>& fields, Index cell, Index i,
                          Gradient<D, N>& result, SlopeBounds<N>& bounds) noexcept {
  const auto store = [&](auto& values, const Vector<N>& value) {
    Eigen::Map<Vector<N>>{values.data() + i* N} = value;
  };
  const Vector<N> here = values_of<N>(fields, cell);
  Gradient<D, N> gradient;
  gradient.fill(Vector<N>::Zero());
  Vector<N> lowest = Vector<N>::Zero();
  Vector<N> highest = Vector<N>::Zero();
  for (const StencilCell<D>& near : tables.stencil_of(cell)) {
    const Vector<N> difference = values_of<N>(fields, near.cell) - here;
    lowest = lowest.cwiseMin(difference);
    highest = highest.cwiseMax(difference);
    for (int d = 0; d < D; ++d) gradient[static_cast<std::size_t>(d)] += near.weight[d] * difference;
  }
  Vector<N> down = Vector<N>::Zero();
  Vector<N> up = Vector<N>::Zero();
  for (const CellFace<D>& face : tables.faces_of(cell)) {
    const Vector<N> change = change_along<D, N>(gradient, face.offset);
    down = down.cwiseMin(change);
    up = up.cwiseMax(change);
  }
  result = gradient;
  store(bounds.lowest, lowest);
  store(bounds.highest, highest);
  store(bounds.down, down);
  store(bounds.up, up);
  store(bounds.width, Vector<N>::Constant(tables.widths.data()[cell]));
}

/// The limiter's factors of `count` values.  Eq. (T33)
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

/// u + gradient . offset.
template <int D, int N>
[[nodiscard]] Vector<N> extrapolated(const CellStates<N>& fields, Index cell, const Gradient<D, N>& gradient,
                                     const Vector<D>& offset) noexcept {
  return values_of<N>(fields, cell) + change_along<D, N>(gradient, offset);
}

/// Whether a law can take the states that a gradient makes at the faces of its cell.
template <class Law, int D, int N>
[[nodiscard]] bool is_admissible(const Law& law, const FaceTables<D>& tables, const CellStates<N>& fields,
                                 Index cell, const Gradient<D, N>& gradient) noexcept {
  bool result = true;
  for (const CellFace<D>& face : tables.faces_of(cell)) {
    const Vector<N> value = extrapolated<D, N>(fields, cell, gradient, face.offset);
    typename CellStates<N>::State state;
    for (int k = 0; k < N; ++k) state[static_cast<std::size_t>(k)] = value[k];
    result = result && law.is_admissible(state);
  }
  return result;
}

/// Limited gradients of cells begin .. end - 1, zero where a face would get a state that cannot be.
/// Eqs. (T31), (T33)
template <class Law, class R, int D, int N>
[[gnu::noinline]] void find_gradients(const FaceTables<D>& tables, const Law& law, const R& reconstruction,
                                      const CellStates<N>& fields, Index begin, Index end,
                                      Gradient<D, N>* __restrict gradients) noexcept {
  SlopeBounds<N> bounds{};
  for (Index first = begin; first < end; first += SlopeBounds<N>::num_cells) {
    const Index count = std::min(SlopeBounds<N>::num_cells, end - first);
    for (Index i = 0; i < count; ++i) {
      find_gradient<D, N>(tables, fields, first + i, i, gradients[first + i], bounds);
    }
    limit(reconstruction.limiter, bounds, count * N);
    for (Index i = 0; i < count; ++i) {
      const Index cell = first + i;
      Gradient<D, N>& gradient = gradients[cell];
      if constexpr (R::is_common) {
        const double factor = common_factor<N>(bounds, i, values_of<N>(fields, cell), reconstruction.scale);
        for (Vector<N>& along : gradient) along *= factor;
      } else {
        const Eigen::Map<const Vector<N>> factor{bounds.factor.data() + i * N};
        for (Vector<N>& along : gradient) along = along.cwiseProduct(factor);
      }
      if constexpr (HasAdmissibleStates<Law>) {
        if (!is_admissible<Law, D, N>(law, tables, fields, cell, gradient)) gradient.fill(Vector<N>::Zero());
      }
    }
  }
}

}  // namespace scree::transport::detail
