#pragma once

#include <scree/transport/boundaries.hpp>
#include <scree/transport/concepts.hpp>

#include <type_traits>

namespace scree::transport {

/// All that decides du/dt: where, what, and how it is approximated.
template <LatticeGrid G, class L, class R, class F>
struct Discretisation {
  static constexpr int dimension = G::dimension;
  static constexpr int num_components = PointLawOf<L>::num_components;
  using Grid = G;
  using Law = L;
  using State = typename PointLawOf<L>::State;
  static_assert(ConservationLaw<L, dimension>);
  static_assert(Reconstruction<R, num_components>);
  static_assert(NumericalFlux<F, PointLawOf<L>, dimension>);

  G grid;
  L law;
  R reconstruction;
  F flux;
  BoxBoundaries<dimension, num_components> boundaries;
};

}  // namespace scree::transport
