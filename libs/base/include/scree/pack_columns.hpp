#pragma once

#include <scree/index.hpp>

#include <array>
#include <cstddef>
#include <cstring>
#include <utility>

// Packs of numbers from columns, and back.

namespace scree::detail {

/// How many numbers Real is: double is one. A pack is numbers and nothing else.
template <class Real>
inline constexpr std::size_t num_lanes = sizeof(Real) / sizeof(double);

/// Whether Real is two numbers of half the lanes, `low` and `high`. They are loaded and stored one after the
/// other: a copy of both at once would go through memory.
template <class Real>
concept HasHalves = requires(const Real& real) {
  Real{real.low, real.high};
};

template <class Real>
[[nodiscard]] Real loaded(const double* values) noexcept {
  if constexpr (HasHalves<Real>) {
    using Half = decltype(Real::low);
    return {loaded<Half>(values), loaded<Half>(values + num_lanes<Half>)};
  } else {
    Real result;
    std::memcpy(static_cast<void*>(&result), values, sizeof(Real));
    return result;
  }
}

template <class Real>
void store(const Real& real, double* values) noexcept {
  if constexpr (HasHalves<Real>) {
    store(real.low, values);
    store(real.high, values + num_lanes<decltype(Real::low)>);
  } else {
    const Real copy = real;
    std::memcpy(values, static_cast<const void*>(&copy), sizeof(Real));
  }
}

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmissing-braces"  // a member may be an aggregate itself
/// An aggregate of Real, a number from each column.
template <class Aggregate, class Real, class Pointer, std::size_t N>
[[nodiscard]] Aggregate loaded_from(const std::array<Pointer, N>& columns, Index p) noexcept {
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return Aggregate{loaded<Real>(columns[I] + p)...};
  }
  (std::make_index_sequence<N>{});
}
#pragma GCC diagnostic pop

/// Stores each member of an aggregate of Real in its column, if there is one: member by member, for a copy of
/// all at once, or a loop over them, would go through memory.
template <class Real, class Aggregate, std::size_t N>
void store_members(const Aggregate& aggregate, const std::array<double*, N>& columns, Index p) noexcept {
  static_assert(N == 0 || sizeof(Aggregate) == N * sizeof(Real));
  const auto* members = reinterpret_cast<const Real*>(&aggregate);  // one after another, as asserted
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    ((columns[I] != nullptr ? store(members[I], columns[I] + p) : void()), ...);
  }
  (std::make_index_sequence<N>{});
}

}  // namespace scree::detail
