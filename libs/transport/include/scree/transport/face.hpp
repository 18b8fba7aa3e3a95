#pragma once

#include <scree/tensor.hpp>

namespace scree::transport {

/// The index of a neighbour that is not there.
constexpr Index no_site = -1;

/// A face between two sites of a lattice, normal to `axis`; its normal points from owner to neighbour.
struct Face {
  Index owner;      ///< site on the low side along the axis; at a boundary the site inside
  Index neighbour;  ///< site on the high side; no_site at a boundary
  int axis;         ///< 0 .. D-1
  double distance;  ///< between the two sites [m]
};

/// What passes through a face.
template <class State>
struct FaceFlux {
  State value;   ///< flux along the normal [unit of the state x m/s]
  double speed;  ///< bound of all wave speeds that the flux contains, >= 0 [m/s]
};

/// The values of a reconstruction at the two faces of a site along one axis.
template <class State>
struct Edges {
  State low;   ///< at the face on the low side
  State high;  ///< at the face on the high side
};

}  // namespace scree::transport
