#pragma once

#include <scree/mpm/boundaries/no_slip.hpp>
#include <scree/mpm/boundaries/slip.hpp>
#include <scree/mpm/boundaries/wall_lines.hpp>
#include <scree/mpm/boundary.hpp>

#include <memory>
#include <variant>

namespace scree::mpm {

/// Every wall that holds whole components of velocity. A new one is a line here, its header and its test. (A
/// periodic axis is no wall but a property of the grid; walls with friction are made from a law, by
/// `make_frictional_wall`.)
using AnyWall = std::variant<NoSlip, Slip>;

/// A plane wall on an end of the mesh, seen as a mirror: material beyond it is the image of the material
/// inside, with the held components of velocity reversed and the others kept. So shape functions that reach
/// past the wall stay whole, and the velocity held is exactly zero on it.  @see Eqs. (M14)-(M16)
template <int D>
[[nodiscard]] std::unique_ptr<Boundary<D>> make_wall(const AnyWall& rule, int axis, Side side);

}  // namespace scree::mpm
