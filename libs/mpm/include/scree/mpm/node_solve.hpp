#pragma once

#include <scree/mpm/nodes.hpp>
#include <scree/mpm/particles.hpp>

namespace scree::mpm {

/// A part of the forces that is solved for on the nodes in each step, because it would bound an explicit one.
/// It is left out of the stress that points give to the nodes.
template <int D, int V>
class NodeSolve {
 public:
  NodeSolve() = default;
  NodeSolve(const NodeSolve&) = delete;
  NodeSolve& operator=(const NodeSolve&) = delete;
  virtual ~NodeSolve() = default;

  /// Changes the velocities of nodes, and their increments alike, over dt [s]: after momentum has been
  /// advanced and walls hold, before their images follow.  Eq. (M29)
  /// @param mass_floor [kg], lighter nodes take no part  @throws RunError if it cannot be solved
  virtual void solve(const Particles<D, V>& particles, Nodes<D>& nodes, double dt, double mass_floor) = 0;
};

}  // namespace scree::mpm
