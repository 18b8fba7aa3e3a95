#pragma once

#include <scree/input_column.hpp>
#include <scree/rheology/block_kernel.hpp>
#include <scree/rheology/concepts.hpp>
#include <scree/update_block.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string_view>

namespace scree::rheology {

/// Any number of points under one law, a column of one number per point for everything. Components that a
/// flow does not have may share a column of zeros; no column that is written overlaps another. In a plane, or
/// of axial symmetry, the gradients xz, yz, zx and zy are left empty, and so may be the stresses xz and yz:
/// then a law runs by its form for that, if it has one, and memory that a plane lacks, which must be 0, is
/// neither read nor written.
template <class Law>
struct LawColumns {
  std::array<std::span<const double>, 9> velocity_gradient{};        ///< L, row by row [1/s]
  std::span<const double> density{};                                 ///< at the end of the step [kg/m^3]
  std::array<std::span<const double>, Law::inputs.size()> inputs{};  ///< in the order of the law's `inputs`
  std::array<std::span<double>, Law::states.size()> states{};  ///< as the law's `states`: old in, new out
  std::array<std::span<double>, 6> stress{};                   ///< only written: xx, yy, zz, xy, xz, yz [Pa]
};

namespace detail {

inline constexpr std::array<std::string_view, 9> names_of_gradient{
    "velocity_gradient_xx", "velocity_gradient_xy", "velocity_gradient_xz",
    "velocity_gradient_yx", "velocity_gradient_yy", "velocity_gradient_yz",
    "velocity_gradient_zx", "velocity_gradient_zy", "velocity_gradient_zz"};
inline constexpr std::array<std::string_view, 6> names_of_stress{"stress_xx", "stress_yy", "stress_zz",
                                                                 "stress_xy", "stress_xz", "stress_yz"};
inline constexpr std::array<std::size_t, 6> places_of_stress{0, 4, 8, 1, 2, 5};  // in a tensor, row by row

/// @throws InputError naming law, column and both lengths, unless they are equal.
void require_length(std::string_view law, std::string_view column, std::size_t length, std::size_t expected);
/// @throws InputError naming law, step and bound, unless the step is finite and positive.
void require_step(std::string_view law, double dt);
/// @throws InputError naming law, column, value, point and range, unless all values are in the range.
void require_values(std::string_view law, const InputColumn& column, std::span<const double> values);
/// @throws InputError naming law, sum, value and point, unless three columns of six add up to 0 at all
/// points, but for a millionth of the largest in the batch.
void require_trace_zero(std::string_view law, std::span<const StateColumn, 6> columns,
                        std::span<const std::span<double>, 6> values);

/// Whether a batch is of a flow in a plane.
template <class Law>
[[nodiscard]] bool is_plane(const LawColumns<Law>& columns) noexcept {
  return std::ranges::all_of(out_of_plane,
                             [&](std::size_t i) { return columns.velocity_gradient[i].empty(); });
}

template <class Law>
void require_equal_lengths(const LawColumns<Law>& columns) {
  const bool is_in_plane = is_plane(columns);
  const auto require = [&](std::string_view name, std::size_t length) {
    require_length(Law::name, name, length, columns.density.size());
  };
  const auto may_be_absent = [&](std::size_t place) {
    return is_in_plane && std::ranges::find(out_of_plane, place) != out_of_plane.end();
  };
  for (std::size_t i = 0; i < 9; ++i) {
    if (!may_be_absent(i)) require(names_of_gradient[i], columns.velocity_gradient[i].size());
  }
  for (std::size_t i = 0; i < Law::inputs.size(); ++i) require(Law::inputs[i].name, columns.inputs[i].size());
  for (std::size_t i = 0; i < Law::states.size(); ++i) require(Law::states[i].name, columns.states[i].size());
  for (std::size_t i = 0; i < 6; ++i) {
    if (columns.stress[i].empty() && may_be_absent(places_of_stress[i])) continue;
    require(names_of_stress[i], columns.stress[i].size());
  }
}

/// The points that make whole packs, where they are.
template <class Law>
[[nodiscard]] LawBlock<Law> whole_packs(const LawColumns<Law>& columns) noexcept {
  LawBlock<Law> block;
  block.num_points = static_cast<Index>(columns.density.size()) / pack_size * pack_size;
  for (std::size_t i = 0; i < 9; ++i) {
    if (!columns.velocity_gradient[i].empty()) {
      block.velocity_gradient[i] = {columns.velocity_gradient[i].data(), 1};
    }
  }
  block.density = columns.density.data();
  const auto start = [](const auto& column) { return column.data(); };
  std::ranges::transform(columns.inputs, block.inputs.begin(), start);
  std::ranges::transform(columns.states, block.states.begin(), start);
  for (std::size_t i = 0; i < 6; ++i) {
    if (!columns.stress[i].empty()) block.stress[places_of_stress[i]] = columns.stress[i].data();
  }
  return block;
}

/// Updates the points from `first` on, fewer than a pack, in a pack of their own. It is filled up with copies
/// of the last point, whose answers go nowhere.
template <class Law>
[[nodiscard]] BlockStiffness update_rest(BlockKernel<Law> kernel, const Law& law,
                                         const LawColumns<Law>& columns, std::size_t first,
                                         double dt) noexcept {
  using Numbers = std::array<double, static_cast<std::size_t>(pack_size)>;
  std::array<Numbers, 10 + Law::inputs.size() + Law::states.size() + 6> numbers{};
  std::size_t num_used = 0;
  const auto filled = [&](std::span<const double> column) {
    Numbers& pack = numbers[num_used++];
    pack.fill(column.back());
    std::ranges::copy(column.subspan(first), pack.begin());
    return pack.data();
  };
  LawBlock<Law> block;
  block.num_points = pack_size;
  for (std::size_t i = 0; i < 9; ++i) {
    if (!columns.velocity_gradient[i].empty()) {
      block.velocity_gradient[i] = {filled(columns.velocity_gradient[i]), 1};
    }
  }
  block.density = filled(columns.density);
  std::ranges::transform(columns.inputs, block.inputs.begin(), filled);
  std::ranges::transform(columns.states, block.states.begin(), filled);
  for (const std::size_t place : places_of_stress) block.stress[place] = numbers[num_used++].data();

  const BlockStiffness worst = kernel(law, block, dt);

  const auto put_back = [&](const double* pack, std::span<double> column) {
    if (!column.empty()) std::copy_n(pack, column.size() - first, column.subspan(first).begin());
  };
  for (std::size_t i = 0; i < Law::states.size(); ++i) put_back(block.states[i], columns.states[i]);
  for (std::size_t i = 0; i < 6; ++i) put_back(block.stress[places_of_stress[i]], columns.stress[i]);
  return worst;
}

}  // namespace detail

/// Brings any number of points up to date over a step: writes their states and stresses, by the law's kernel
/// for an instruction set. A point gets the same bits wherever it is and however many others there are.
/// Nothing is allocated, and numbers are not looked at: `validate(law)` checks its parameters, and
/// `validate_columns` what it reads where that comes in; what a law has left in its memory is sound.
/// @param dt step [s]  @param set one that runs here
/// @returns the largest speed, viscosity and rate of the points; if its `unsolved` is not 0 the step must not
/// be taken.
/// @throws InputError naming law, column and both lengths if a column is not as long as that of the density,
/// and law and step if that is not positive. Nothing is written then.
template <ConstitutiveLaw Law>
BlockStiffness update_batch(const Law& law, const LawColumns<Law>& columns, double dt,
                            InstructionSet set = widest_instruction_set()) {
  detail::require_step(Law::name, dt);
  detail::require_equal_lengths(columns);
  const BlockKernel<Law> kernel = kernel_of(law, set);
  const LawBlock<Law> block = detail::whole_packs(columns);
  BlockStiffness worst;
  if (block.num_points > 0) worst = kernel(law, block, dt);
  const auto first = static_cast<std::size_t>(block.num_points);
  if (first < columns.density.size()) {
    BlockStiffness rest = detail::update_rest(kernel, law, columns, first, dt);
    rest.unsolved_point += block.num_points;  // only read where there is one
    worst.widen(rest);
  }
  return worst;
}

/// Checks every number that a batch reads: velocity gradients and states are finite, densities positive,
/// inputs in the ranges that the law declares; in a plane, memory that it lacks is 0; the trace of a tensor
/// that has none (`remembers_deviator`) is 0, up to a millionth of its largest component in the batch.
/// @throws InputError naming law, column or sum of columns, value, point and range of the first that is not;
/// law, column and both lengths if a column is not as long as that of the density.
template <ConstitutiveLaw Law>
void validate_columns(const LawColumns<Law>& columns) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr Interval finite{-infinity, infinity};
  detail::require_equal_lengths(columns);
  for (std::size_t i = 0; i < 9; ++i) {
    detail::require_values(Law::name, {detail::names_of_gradient[i], "1/s", 0, finite},
                           columns.velocity_gradient[i]);
  }
  detail::require_values(Law::name, {"density", "kg/m^3", 0}, columns.density);
  for (std::size_t i = 0; i < Law::inputs.size(); ++i) {
    detail::require_values(Law::name, Law::inputs[i], columns.inputs[i]);
  }
  const auto range_of = [&]([[maybe_unused]] std::size_t state) {
    if constexpr (HasPlaneForm<Law>) {
      const bool is_in_plane = std::ranges::find(Law::plane_states, state) != Law::plane_states.end();
      if (detail::is_plane(columns) && !is_in_plane) return Interval{0, 0, false};
    }
    return finite;
  };
  for (std::size_t i = 0; i < Law::states.size(); ++i) {
    detail::require_values(Law::name, {Law::states[i].name, Law::states[i].unit, 0, range_of(i)},
                           columns.states[i]);
  }
  if constexpr (remembers_deviator<Law>) {
    detail::require_trace_zero(Law::name, std::span{Law::states}.template first<6>(),
                               std::span{columns.states}.template first<6>());
  }
}

}  // namespace scree::rheology
