#pragma once

#include <scree/constitutive_law.hpp>
#include <scree/error.hpp>
#include <scree/rheology/kinematics.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <experimental/simd>
#include <span>
#include <type_traits>
#include <utility>

namespace scree::rheology {

/// Many points under one law, a column of one number per point for everything; all of one length.
template <class Law>
struct LawColumns {
  std::array<std::span<const double>, 9> velocity_gradient;            ///< L, row by row [1/s]
  std::span<const double> density;                                     ///< at the end of the step [kg/m^3]
  std::array<std::span<const double>, Law::inputs.size()> inputs;      ///< in the order of the law's `inputs`
  std::array<std::span<const double>, Law::states.size()> old_states;  ///< in the order of the law's `states`
  std::array<std::span<double>, Law::states.size()> states;  ///< at the end of the step; may be `old_states`
  std::array<std::span<double>, 6> stress;                   ///< xx, yy, zz, xy, xz, yz [Pa]
};

namespace detail {

/// Real is double or a pack of doubles.
template <class Real>
[[nodiscard]] Real loaded(std::span<const double> column, std::size_t first) noexcept {
  if constexpr (std::is_same_v<Real, double>) {
    return column[first];
  } else {
    return Real(column.data() + first, std::experimental::element_aligned);
  }
}

template <class Real>
void store(const Real& value, std::span<double> column, std::size_t first) noexcept {
  if constexpr (std::is_same_v<Real, double>) {
    column[first] = value;
  } else {
    value.copy_to(column.data() + first, std::experimental::element_aligned);
  }
}

/// An aggregate of Real, a member from each column.
template <class Aggregate, class Real, std::size_t N>
[[nodiscard]] Aggregate loaded_from(const std::array<std::span<const double>, N>& columns,
                                    std::size_t first) noexcept {
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return Aggregate{loaded<Real>(columns[I], first)...};
  }
  (std::make_index_sequence<N>{});
}

/// Stores each member of an aggregate of Real in its column, one by one: a copy of all at once would go
/// through memory.
template <class Real, class Aggregate, std::size_t N>
void store_members(const Aggregate& aggregate, const std::array<std::span<double>, N>& columns,
                   std::size_t first) noexcept {
  static_assert(N == 0 || sizeof(Aggregate) == N * sizeof(Real));
  for (std::size_t i = 0; i < N; ++i) {
    Real member;
    const auto* from = reinterpret_cast<const std::byte*>(&aggregate) + i * sizeof(Real);
    std::memcpy(static_cast<void*>(&member), from, sizeof(Real));  // a pack is numbers and nothing else
    store(member, columns[i], first);
  }
}

/// Updates the points from `first` on, as many as Real has lanes.
/// @return Response::unsolved of each
template <class Real, class Law>
[[nodiscard]] Real update_points(const Law& law, const LawColumns<Law>& columns, std::size_t first,
                                 double dt) noexcept {
  using Input = typename Law::template Input<Real>;
  using State = typename Law::template State<Real>;
  Deformation<Real> deformation{};
  for (std::size_t i = 0; i < 9; ++i) {
    deformation.velocity_gradient.components[i] = loaded<Real>(columns.velocity_gradient[i], first);
  }
  deformation.density = loaded<Real>(columns.density, first);
  const auto response = law.update(deformation, loaded_from<Input, Real>(columns.inputs, first),
                                   loaded_from<State, Real>(columns.old_states, first), Real(dt));
  store_members<Real>(response.state, columns.states, first);
  const Symmetric<Real> stress = symmetric(response.stress);
  store_members<Real>(stress, columns.stress, first);
  return response.unsolved;
}

}  // namespace detail

/// Brings many points up to date, as many at once as `Real` has lanes and the rest one by one; each point
/// gets the bits that it would get alone, for one instruction set and contraction of products and sums.
/// @tparam Real double, or a pack of doubles (std::experimental::simd)
/// @param dt step [s]
/// @return the worst of the points' `Response::unsolved` [-]; if it is not 0 the step must not be taken
/// @throws InputError if a column has another length than that of the density
template <class Real = double, class Law>
[[gnu::flatten]] double update_batch(const Law& law, const LawColumns<Law>& columns, double dt) {
  const std::size_t num_points = columns.density.size();
  const auto fits = [&](const auto& column) { return column.size() == num_points; };
  require(std::ranges::all_of(columns.velocity_gradient, fits) && std::ranges::all_of(columns.inputs, fits) &&
              std::ranges::all_of(columns.old_states, fits) && std::ranges::all_of(columns.states, fits) &&
              std::ranges::all_of(columns.stress, fits),
          "update_batch: every column must have a number for each point, as the density has");
  double unsolved = 0;
  std::size_t first = 0;
  if constexpr (!std::is_same_v<Real, double>) {
    Real worst = 0;
    for (; first + Real::size() <= num_points; first += Real::size()) {
      const Real here = detail::update_points<Real>(law, columns, first, dt);
      worst = select(here > worst, here, worst);
    }
    unsolved = std::experimental::hmax(worst);
  }
  for (; first < num_points; ++first) {
    unsolved = std::max(unsolved, detail::update_points<double>(law, columns, first, dt));
  }
  return unsolved;
}

}  // namespace scree::rheology
