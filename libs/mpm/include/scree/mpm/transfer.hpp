#pragma once

#include <scree/instruction_set.hpp>
#include <scree/mpm/block_motion.hpp>
#include <scree/mpm/boundary.hpp>
#include <scree/mpm/nodes.hpp>
#include <scree/mpm/particle_blocks.hpp>
#include <scree/mpm/particles.hpp>
#include <scree/mpm/shapes.hpp>
#include <scree/mpm/transfers.hpp>

#include <memory>

namespace scree::mpm {

/// Points to nodes and back, for one shape and one transfer rule; chosen once, called once per block.
template <int D, int V>
class Transfer {
 public:
  Transfer() = default;
  Transfer(const Transfer&) = delete;
  Transfer& operator=(const Transfer&) = delete;
  virtual ~Transfer() = default;

  [[nodiscard]] virtual NodeRecord record() const noexcept = 0;
  [[nodiscard]] virtual double stencil_shift() const noexcept = 0;
  /// Nodes along each axis that a block's points can reach, from `block_skin` before its first cell on.
  [[nodiscard]] virtual Index tile_edge() const noexcept = 0;

  /// Adds mass, momentum, and force (an impulse over dt [s] unless nodes have increments) of a block's
  /// points.
  virtual void scatter(const Particles<D, V>& particles, const ParticleBlock<D>& block, Nodes<D>& nodes,
                       double dt) const noexcept = 0;

  /// After `scatter`, where a wall cuts shape functions off: what the block's points gave to images past that
  /// end will come home with the velocity that they have, by their gradient, where it comes, and their force
  /// with the slopes by which they take it.  Eqs. (M183), (M197)
  /// @param dt of the step [s], as of `scatter`: forces are impulses over it unless nodes have increments
  virtual void scatter_cut(const Particles<D, V>& particles, const ParticleBlock<D>& block, Nodes<D>& nodes,
                           const MeshEnd& end, double dt) const noexcept = 0;

  /// Takes velocities back to the points, moves them by dt [s], updates their density.  Eqs. (M11)-(M13)
  [[nodiscard]] virtual BlockMotion gather(Particles<D, V>& particles, const ParticleBlock<D>& block,
                                           const Nodes<D>& nodes, double dt) const noexcept = 0;

  /// Whether `gather_cut` does anything: it does if gradients are affine and three nodes are left of a
  /// stencil that is cut off.
  [[nodiscard]] virtual bool gathers_cut() const noexcept = 0;
  /// After `gather`, where a wall cuts shape functions off: makes gradients the best affine ones by the
  /// weights that are left, and density alike.  Eq. (M197)
  /// @param position of all points as they gathered, in the form of its column
  /// @param dt of the step [s], in which densities change by the gradients
  virtual void gather_cut(Particles<D, V>& particles, const ParticleBlock<D>& block, const Nodes<D>& nodes,
                          const MeshEnd& end, const double* position, double dt) const noexcept = 0;
};

/// @param set what its loops are compiled for: one of instruction_sets()
template <int D, int V>
[[nodiscard]] std::unique_ptr<Transfer<D, V>> make_transfer(const AnyShape& shape, const AnyTransfer& rule,
                                                            InstructionSet set = widest_instruction_set());

}  // namespace scree::mpm
