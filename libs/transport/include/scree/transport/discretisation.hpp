#pragma once

#include <scree/transport/boundaries.hpp>
#include <scree/transport/concepts.hpp>

namespace scree::transport {

/// The boundaries that a kind of grid asks for; each kind says so for itself.
template <class Grid, int N>
struct BoundariesOf;

template <LatticeGrid Grid, int N>
struct BoundariesOf<Grid, N> {
  using type = BoxBoundaries<Grid::dimension, N>;
};

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
