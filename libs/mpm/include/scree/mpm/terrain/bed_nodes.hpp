#pragma once

#include <scree/mpm/nodes.hpp>
#include <scree/mpm/terrain/signed_distance.hpp>
#include <scree/symmetry.hpp>

#include <vector>

namespace scree::mpm {

/// A node that a bed holds.
struct BedNode {
  Index node;        ///< in Nodes
  Vector<3> normal;  ///< of unit length, into the material; zero beyond the axes of the mesh
  /// The part of the bed that the node stands for [m^(D-1)], integral of its hat function over the bed, and
  /// at least `least_area_share` of a cell's face; of a radian round an axis.  Eqs. (M62), (M177)
  double area;
};

/// What a node below the bed gets, whose hat does not reach it: its friction is in proportion to what it
/// stops, and does not depend on the area; a drag in proportion to the area is then nothing.  [-]
inline constexpr double least_area_share = 1e-9;

/// The nodes at or below a surface, and those above whose hat function reaches it, sum_d |n_d| h_d >
/// distance: on them the pressure of the bed acts.  Eq. (M61) Nodes of which the surface knows nothing (NaN)
/// are left out.
/// @throws InputError if the surface reaches no node of the mesh.
template <int D>
[[nodiscard]] std::vector<BedNode> bed_nodes(const CartesianGrid<D>& grid, const AnySurface<D>& surface,
                                             Symmetry symmetry = Symmetry::plane);

/// Where a node of Nodes is, images past the mesh among them [m].
template <int D>
[[nodiscard]] Vector<D> node_position(const Nodes<D>& nodes, Index node);

}  // namespace scree::mpm
