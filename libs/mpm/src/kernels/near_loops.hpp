#pragma once

#include "stencil_loops.hpp"

#include <scree/mpm/point_transfer.hpp>

#include <array>
#include <cstddef>

/// The loops over the nodes of a pack of points whose stencils begin at one node or at neighbouring ones: of
/// sorted points most packs, where a cell has as many points as a pack. Lanes are points: a node is read once
/// for all of them. A node that is no number makes none of the whole pack, of those too that do not reach it.
namespace scree::mpm::SCREE_INSTRUCTION_SET {

/// Where the stencils of a pack of points begin.
template <int D>
struct Beginnings {
  Components<double, D> first;  ///< of all, along each axis
  Components<bool, D> are_one;  ///< whether all begin there; in two dimensions, along both axes or neither
  bool are_near;                ///< whether none begins beyond the next node

  explicit Beginnings(const Components<Pack, D>& base) noexcept {
    Components<Pack::Mask, D> one;
    Pack::Mask near = ~Pack::Mask{};
    for (std::size_t axis = 0; axis < D; ++axis) {
      const Pack least = least_lane(base[axis]);
      first[axis] = least[0];
      one[axis] = base[axis] == least;
      near &= base[axis] <= least + 1;
    }
    if constexpr (D == 2) one[0] = one[1] = one[0] & one[1];
    for (std::size_t axis = 0; axis < D; ++axis) are_one[axis] = Pack::all_of(one[axis]);
    are_near = Pack::all_of(near);
  }
};

/// The nodes that the points of a pack reach together, and the points' weights on them.
template <int D, std::size_t S>
struct NearNodes {
  using Along = std::array<Pack, S + 1>;

  Components<Along, D> weight;
  Components<Along, D> slope;
  Components<Pack, D> xi;            ///< of the points from the first node [spacings]
  Components<std::size_t, D> count;  ///< along each axis: S, or one more

  NearNodes(const Stencil<Pack, D, S>& stencil, const Beginnings<D>& begin) noexcept {
    for (std::size_t axis = 0; axis < D; ++axis) {
      count[axis] = begin.are_one[axis] ? S : S + 1;
      const Pack beyond = stencil.base[axis] - begin.first[axis];
      xi[axis] = stencil.xi[axis] + beyond;
      const Pack::Mask is_at_first = beyond == Pack{0};
      spread(stencil.weight[axis], is_at_first, begin.are_one[axis], weight[axis]);
      spread(stencil.slope[axis], is_at_first, begin.are_one[axis], slope[axis]);
    }
  }

 private:
  /// Each point's own weights, with zeros where its stencil does not go.
  static void spread(const std::array<Pack, S>& own, const Pack::Mask& is_at_first, bool are_one,
                     Along& along) noexcept {
    if (are_one) {
      for (std::size_t i = 0; i < S; ++i) along[i] = own[i];
      return;
    }
    along[0] = select(is_at_first, own[0], Pack{0});
    for (std::size_t i = 1; i < S; ++i) along[i] = select(is_at_first, own[i], own[i - 1]);
    along[S] = select(is_at_first, Pack{0}, own[S - 1]);
  }
};

/// What the nodes give of one field: sum N_i node, and for each axis another sum, by b_ij or i N_i.
template <int Axes>
struct NearSum {
  Pack value{0};
  std::array<Pack, static_cast<std::size_t>(Axes)> slope;
};

/// Nodes along an axis: compiled for the first one, and in two dimensions for both.
/// @tparam N nodes along the first axis
template <std::size_t N, std::size_t axis, int D, std::size_t S>
[[nodiscard]] inline std::size_t num_near(const NearNodes<D, S>& nodes) noexcept {
  return axis == 0 || D == 2 ? N : nodes.count[axis];
}

/// One field at a time, whose sums stay in registers.
/// @param node where the field stands in the record of the first node  @tparam N nodes along the first axis
template <std::size_t N, bool has_slope, int D, std::size_t S, int Axes = D>
[[gnu::always_inline]] inline NearSum<Axes> sum_near(const NearNodes<D, S>& nodes, const Strides<D>& stride,
                                                     const double* node) noexcept {
  constexpr std::size_t axis = Axes - 1;
  NearSum<Axes> sum;
  for (Pack& along : sum.slope) along = Pack{0};
  if constexpr (axis == 0) {
#pragma GCC unroll 8
    for (std::size_t i = 0; i < N; ++i, node += stride.axis[0]) {
      const Pack here{*node};
      sum.value = sum.value + nodes.weight[0][i] * here;
      if constexpr (has_slope) sum.slope[0] = sum.slope[0] + nodes.slope[0][i] * here;
    }
  } else {
    for (std::size_t i = 0; i < num_near<N, axis>(nodes); ++i, node += stride.axis[axis]) {
      const auto rest = sum_near<N, has_slope, D, S, Axes - 1>(nodes, stride, node);
      const Pack& w = nodes.weight[axis][i];
      sum.value = sum.value + w * rest.value;
      if constexpr (has_slope) {
        for (std::size_t j = 0; j < axis; ++j) sum.slope[j] = sum.slope[j] + w * rest.slope[j];
        sum.slope[axis] = sum.slope[axis] + nodes.slope[axis][i] * rest.value;
      }
    }
  }
  return sum;
}

/// What the nodes give of one field by affine weights: sum N_i node, and for each axis sum i N_i node, where
/// i counts from the first node. The sums go backwards, so that each node adds once more what lies beyond it.
template <std::size_t N, int D, std::size_t S, int Axes = D>
[[gnu::always_inline]] inline NearSum<Axes> moments_near(const NearNodes<D, S>& nodes,
                                                         const Strides<D>& stride,
                                                         const double* node) noexcept {
  constexpr std::size_t axis = Axes - 1;
  NearSum<Axes> sum;
  for (Pack& along : sum.slope) along = Pack{0};
  const std::size_t count = num_near<N, axis>(nodes);
  node += static_cast<std::ptrdiff_t>(count - 1) * stride.axis[axis];  // and back: a place by i costs a fifth
#pragma GCC unroll 8
  for (std::size_t i = count; i > 0; --i) {
    const Pack& w = nodes.weight[axis][i - 1];
    sum.slope[axis] = sum.slope[axis] + sum.value;
    if constexpr (axis == 0) {
      sum.value = sum.value + w * Pack{*node};
    } else {
      const auto rest = moments_near<N, D, S, Axes - 1>(nodes, stride, node);
      sum.value = sum.value + w * rest.value;
      for (std::size_t j = 0; j < axis; ++j) sum.slope[j] = sum.slope[j] + w * rest.slope[j];
    }
    if (i > 1) node -= stride.axis[axis];
  }
  return sum;
}

}  // namespace scree::mpm::SCREE_INSTRUCTION_SET
