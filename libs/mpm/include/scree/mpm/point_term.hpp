#pragma once

#include <scree/mpm/nodes.hpp>
#include <scree/mpm/particle_blocks.hpp>
#include <scree/mpm/particles.hpp>

namespace scree::mpm {

/// Terms of the step beside those of every flow, point by point: one that a run does without costs nothing.
/// Called once per block, in parallel as the transfer is: it may write to nodes near the block's points.
template <int D, int V>
class PointTerm {
 public:
  PointTerm() = default;
  PointTerm(const PointTerm&) = delete;
  PointTerm& operator=(const PointTerm&) = delete;
  virtual ~PointTerm() = default;

  /// Adds to what the nodes have got of the block's points, whose stress is that of this step.  @param dt [s]
  virtual void scatter(Particles<D, V>& particles, const ParticleBlock<D>& block, Nodes<D>& nodes,
                       double dt) const noexcept = 0;
  /// When the points have moved by dt [s].
  virtual void gather(Particles<D, V>& particles, const ParticleBlock<D>& block,
                      double dt) const noexcept = 0;
};

}  // namespace scree::mpm
