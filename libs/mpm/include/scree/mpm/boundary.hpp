#pragma once

#include <scree/mpm/nodes.hpp>

#include <cstdint>
#include <optional>
#include <span>

namespace scree::mpm {

/// An end of an axis of the mesh.
struct MeshEnd {
  int axis;   ///< its number
  Side side;  ///< which end of it
};

/// What acts on the nodes between scatter and gather.
template <int D>
class Boundary {
 public:
  Boundary() = default;
  Boundary(const Boundary&) = delete;
  Boundary& operator=(const Boundary&) = delete;
  virtual ~Boundary() = default;

  /// The end where `fold` cuts shape functions off, if it does: what points gave to images there is then put
  /// right beforehand, so that it comes home with the velocity of the place where it comes.  Eq. (M183)
  [[nodiscard]] virtual std::optional<MeshEnd> cuts_shapes() const noexcept { return std::nullopt; }
  /// How many means of what points carry it needs at its nodes: one past the last that it reads, 0 if none.
  /// A run with such a boundary has `NodeMeans`, which bring them.  Eq. (M170)
  [[nodiscard]] virtual Index num_means() const noexcept { return 0; }
  /// Marks all nodes in use that it may read means of now, with one mark for each node.
  virtual void mark_read(const Nodes<D>& /*nodes*/, std::span<std::uint8_t> /*is_read*/) const noexcept {}
  /// Whether it may read those of other nodes in the next step.
  [[nodiscard]] virtual bool reads_elsewhere() const noexcept { return false; }
  /// Before momentum is advanced: brings home what points gave to nodes outside. All mass of a node then
  /// falls alike: where the weight of what comes home is to act otherwise, the difference comes with its
  /// forces.
  /// @param gravity of each component of velocity [m/s^2]  @param dt the step [s]
  virtual void fold(Nodes<D>& nodes, const double* gravity, double dt) const noexcept = 0;
  /// After it: sets the velocities that the boundary prescribes.  @param dt the step [s]
  virtual void hold(Nodes<D>& nodes, double dt) const noexcept = 0;
  /// `hold` for velocities that are only mapped to the nodes, while no force acts: what gives a force instead
  /// of a velocity leaves them alone.  Eqs. (M126), (M130)
  virtual void hold_mapped(Nodes<D>& nodes, double dt) const noexcept { hold(nodes, dt); }
  /// When all boundaries hold: sets the velocities of nodes outside.
  virtual void reflect(Nodes<D>& nodes) const noexcept = 0;
  /// At the end of the step: a boundary that moves goes on by dt [s].
  virtual void advance(double /*dt*/) noexcept {}
};

}  // namespace scree::mpm
