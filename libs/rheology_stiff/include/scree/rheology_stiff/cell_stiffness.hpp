#pragma once

#include <scree/tensor.hpp>

namespace scree::rheology {

/// Where in a cell its rate of deformation is taken.
enum class Quadrature {
  centre,  ///< at the centre: does not see velocities that alternate from node to node along two axes
  gauss    ///< at the 2^D points of Gauss: exact for the hat functions of a cell of one viscosity
};

/// How the nodes of one cell resist each other, for hat functions, all cells being alike: with the velocities
/// v_e of its corners [m/s] the mean square of the shear rate is v_e . (matrix v_e), and a cell of viscosity
/// mu that holds the volume Omega of material pulls its corners with -mu Omega matrix v_e.
/// Corner a lies at the high end of axis d if bit d of a is set; V components per corner, component fastest.
/// @see Eqs. (R130) to (R132)
template <int D, int V>
struct CellStiffness {
  static constexpr int num_corners = 1 << D;
  static constexpr int size = num_corners * V;
  using Square = Matrix<size>;

  Square matrix;              ///< [1/m^2]
  double largest_eigenvalue;  ///< of the matrix [1/m^2]
  double largest_ratio;       ///< eigenvalue of its diagonal's inverse times the matrix [-]
};

/// @param spacing edges of the cell [m]
template <int D, int V>
[[nodiscard]] CellStiffness<D, V> make_cell_stiffness(const Vector<D>& spacing, Quadrature quadrature);

}  // namespace scree::rheology
