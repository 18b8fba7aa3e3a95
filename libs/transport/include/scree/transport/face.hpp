#pragma once

#include <scree/tensor.hpp>

namespace scree::transport {

/// The index of a neighbour that is not there.
constexpr Index no_site = -1;

/// The two ends of an axis.
enum class End { low, high };

/// A face between two sites of a lattice, normal to `axis`; its normal points from owner to neighbour.
struct Face {
  Index owner;      ///< site on the low side along the axis; at a boundary the site inside
  Index neighbour;  ///< site on the high side; no_site at a boundary
  int axis;         ///< 0 .. D-1
  double distance;  ///< between the two sites [m]
};

/// A face of any grid, between two cells or on a boundary.
template <int D>
struct GridFace {
  Index owner;               ///< cell that the normal points out of
  Index neighbour;           ///< cell that it points into; no_site on a boundary
  int boundary;              ///< number of the boundary that the face lies on; -1 inside
  Vector<D> normal;          ///< unit, out of the owner
  double area;               ///< [m^(D-1)]
  Vector<D> centre;          ///< [m]
  Vector<D> from_owner;      ///< from the owner's centre to the face's [m]
  Vector<D> from_neighbour;  ///< from the neighbour's, or from its image across a periodic boundary [m]
};

/// What a boundary is told of one of its faces.
template <int D>
struct BoundaryFace {
  Vector<D> centre;   ///< [m]
  Vector<D> outward;  ///< unit normal, out of the grid
  double time;        ///< [s]
};

/// What passes through a face.
template <class State>
struct FaceFlux {
  State value;   ///< flux along the normal [unit of the state x m/s]
  double speed;  ///< bound of all wave speeds that the flux contains, >= 0 [m/s]
};

/// Bounds of all wave speeds along a normal, of either sign [m/s].
struct SpeedRange {
  double lowest;
  double highest;
};

/// The values of a reconstruction at the two faces of a site along one axis.
template <class State>
struct Edges {
  State low;   ///< at the face on the low side
  State high;  ///< at the face on the high side
};

}  // namespace scree::transport
