#pragma once

#include "pack.hpp"

#include <cstddef>

/// The loops over the nodes of one point's stencil. Lanes are the fields of a node; the products of weights
/// are taken axis by axis, so that a node costs two multiply-adds, or one of an affine field.
namespace scree::mpm::SCREE_INSTRUCTION_SET {

/// Weights of the points of a pack along each axis, point fastest.
template <int D, std::size_t S>
struct PackWeights {
  alignas(64) double along[static_cast<std::size_t>(D)][S][Pack::size];
};

/// What goes to a node by the weights N_i, and by the slopes b of each axis: N_i value + b_x slope_0 + ..
template <int Axes>
struct ToNodes {
  Four value;
  Four slope[Axes];
};

/// Steps from node to node in a tile, in doubles.
template <int D>
struct Strides {
  std::ptrdiff_t axis[static_cast<std::size_t>(D)];
};

/// Adds to the nodes N_i value + sum_j b_ij slope_j.
template <int D, std::size_t S, bool has_value, bool has_slope, int Axes>
[[gnu::always_inline]] inline void add_to_nodes(const ToNodes<Axes>& given, const PackWeights<D, S>& weight,
                                                const PackWeights<D, S>& slope, int lane,
                                                const Strides<D>& stride, double* node) noexcept {
  constexpr int axis = Axes - 1;
#pragma GCC unroll 4
  for (std::size_t i = 0; i < S; ++i, node += stride.axis[axis]) {
    const double w = weight.along[axis][i][lane];
    [[maybe_unused]] const double b = slope.along[axis][i][lane];
    if constexpr (axis == 0) {
      Four sum = Four::load(node);
      if constexpr (has_value) sum += w * given.value;
      if constexpr (has_slope) sum += b * given.slope[0];
      sum.store(node);
    } else {
      ToNodes<axis> rest;
      if constexpr (has_value) rest.value = w * given.value;
      if constexpr (has_slope) {
        rest.value = has_value ? rest.value + b * given.slope[axis] : b * given.slope[axis];
        for (int j = 0; j < axis; ++j) rest.slope[j] = w * given.slope[j];
      }
      add_to_nodes<D, S, true, has_slope>(rest, weight, slope, lane, stride, node);
    }
  }
}

/// Adds to the nodes N_i times an affine field: `value` at the first one, and slopes that are steps from one
/// to the next along each axis.
template <int D, std::size_t S, int Axes>
[[gnu::always_inline]] inline void add_affine(const ToNodes<Axes>& given, const PackWeights<D, S>& weight,
                                              int lane, const Strides<D>& stride, double* node) noexcept {
  constexpr int axis = Axes - 1;
  Four here = given.value;
#pragma GCC unroll 4
  for (std::size_t i = 0; i < S; ++i, node += stride.axis[axis]) {
    const double w = weight.along[axis][i][lane];
    if constexpr (axis == 0) {
      (Four::load(node) + w * here).store(node);
    } else {
      ToNodes<axis> rest;
      rest.value = w * here;
      for (int j = 0; j < axis; ++j) rest.slope[j] = w * given.slope[j];
      add_affine<D, S>(rest, weight, lane, stride, node);
    }
    here += given.slope[axis];
  }
}

/// What the nodes give: sum N_i node, and for each axis j sum b_ij node.
template <int D, std::size_t S, bool has_slope, int Axes = D>
[[gnu::always_inline]] inline ToNodes<Axes> sum_of_nodes(const PackWeights<D, S>& weight,
                                                         const PackWeights<D, S>& slope, int lane,
                                                         const Strides<D>& stride,
                                                         const double* node) noexcept {
  constexpr int axis = Axes - 1;
  ToNodes<Axes> sum;
  sum.value = Four::zero();
  for (Four& along : sum.slope) along = Four::zero();
#pragma GCC unroll 4
  for (std::size_t i = 0; i < S; ++i, node += stride.axis[axis]) {
    const double w = weight.along[axis][i][lane];
    [[maybe_unused]] const double b = slope.along[axis][i][lane];
    if constexpr (axis == 0) {
      const Four here = Four::load(node);
      sum.value += w * here;
      if constexpr (has_slope) sum.slope[0] += b * here;
    } else {
      const auto rest = sum_of_nodes<D, S, has_slope, axis>(weight, slope, lane, stride, node);
      sum.value += w * rest.value;
      if constexpr (has_slope) {
        for (int j = 0; j < axis; ++j) sum.slope[j] += w * rest.slope[j];
        sum.slope[axis] += b * rest.value;
      }
    }
  }
  return sum;
}

}  // namespace scree::mpm::SCREE_INSTRUCTION_SET
