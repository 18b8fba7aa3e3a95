#pragma once

#include <scree/transport/boundaries.hpp>
#include <scree/transport/concepts.hpp>

#include <algorithm>

namespace scree::transport {

/// The boundaries that a kind of grid asks for; each kind says so for itself.
template <class Grid, int N>
struct BoundariesOf;

template <LatticeGrid Grid, int N>
struct BoundariesOf<Grid, N> {
  using type = BoxBoundaries<Grid::dimension, N>;
};

/// The largest CFL number at which a reconstruction keeps bounds and total variation of a scalar on a kind
/// of grid. Where cells are unequal a face may go as far as its neighbour's value, whatever the sharpness
/// theta = 2 (1/CFL - 1) of the limiter: 1/2, unless there are no slopes.  Eqs. (T9), (T62)
template <class Grid, class R>
[[nodiscard]] double promised_cfl_on(const R& reconstruction) noexcept {
  const double promised = reconstruction.promised_cfl();
  if constexpr (LatticeGrid<Grid>) {
    if constexpr (!Grid::has_equal_spacing) {
      return std::min(promised, 1 / (1 + std::min(1.0, 2 * (1 / promised - 1))));
    }
  }
  return promised;
}

/// All that decides du/dt: where, what, and how it is approximated.
template <class G, class L, class R, class F>
struct Discretisation {
  static constexpr int dimension = G::dimension;
  static constexpr int num_components = PointLawOf<L>::num_components;
  using Grid = G;
  using Law = L;
  using State = typename PointLawOf<L>::State;
  static_assert(ConservationLaw<L, dimension>);
  static_assert(NumericalFlux<F, PointLawOf<L>, dimension>);

  G grid;
  L law;
  R reconstruction;
  F flux;
  typename BoundariesOf<G, num_components>::type boundaries;
};

/// What bounds an explicit step.
struct StepBounds {
  double limit;  ///< CFL number that a step of one second would have, at the worst cell [1/s].  Eq. (T9)
  double speed;  ///< largest wave speed at any face [m/s]
};

/// du/dt of a conservation law: the right-hand side for any integrator. Each kind of grid has its own.
///
/// Has a type Storage, which holds the states of all cells; `num_sites()`, `holds(site)`, `problem()` and
/// `threads()`; and writes du/dt at a time when called as rates(fields, result, time).  Eqs. (T2), (T10)
template <class Grid, class Law, class Reconstruct, class Flux>
class SemiDiscrete;

}  // namespace scree::transport
