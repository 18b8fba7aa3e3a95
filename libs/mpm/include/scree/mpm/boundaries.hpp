#pragma once

#include <scree/mpm/boundaries/no_slip.hpp>
#include <scree/mpm/boundaries/slip.hpp>
#include <scree/mpm/nodes.hpp>

#include <memory>
#include <variant>

namespace scree::mpm {

/// Every wall. A new one is a line here, its header and its test. (A periodic axis is no wall but a property
/// of the grid.)
using AnyWall = std::variant<NoSlip, Slip>;

/// Which end of an axis.
enum class Side { low, high };

/// What acts on the nodes between scatter and gather.
template <int D>
class Boundary {
 public:
  Boundary() = default;
  Boundary(const Boundary&) = delete;
  Boundary& operator=(const Boundary&) = delete;
  virtual ~Boundary() = default;

  /// Before momentum is advanced: brings home what points gave to nodes outside.
  virtual void fold(Nodes<D>& nodes) const noexcept = 0;
  /// After it: sets the velocities that the boundary prescribes.
  virtual void hold(Nodes<D>& nodes) const noexcept = 0;
  /// When all boundaries hold: sets the velocities of nodes outside.
  virtual void reflect(Nodes<D>& nodes) const noexcept = 0;
};

/// A plane wall on an end of the mesh, seen as a mirror: material beyond it is the image of the material
/// inside, with the held components of velocity reversed and the others kept. So shape functions that reach
/// past the wall stay whole, and the velocity held is exactly zero on it.  @see Eqs. (M14)-(M16)
template <int D>
[[nodiscard]] std::unique_ptr<Boundary<D>> make_wall(const AnyWall& rule, int axis, Side side);

}  // namespace scree::mpm
