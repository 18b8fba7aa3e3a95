#pragma once

#include <scree/blocks.hpp>
#include <scree/grid.hpp>
#include <scree/rheology_stiff/cell_stiffness.hpp>

#include <array>
#include <span>
#include <vector>

namespace scree::rheology {

/// Viscosity between the nodes of a grid, and nothing else: symmetric, never negative, and zero for any rigid
/// motion. Values of nodes are num_nodes x V, component fastest; those of cells are num_cells, first axis
/// fastest. What a cell weighs is its viscosity times the volume of material in it [Pa s m^D].
/// @see Eqs. (R130) to (R135)
template <int D, int V = D>
class ViscousOperator {
 public:
  explicit ViscousOperator(const CartesianGrid<D>& grid, Quadrature quadrature = Quadrature::gauss,
                           Threads threads = {});

  [[nodiscard]] const CartesianGrid<D>& grid() const noexcept { return grid_; }
  [[nodiscard]] const CellStiffness<D, V>& cell() const noexcept { return cell_; }
  [[nodiscard]] Threads threads() const noexcept { return threads_; }
  [[nodiscard]] Index num_nodes() const noexcept { return grid_.nodes().num_sites(); }
  [[nodiscard]] Index num_cells() const noexcept { return grid_.cells().num_sites(); }
  [[nodiscard]] std::size_t num_values() const noexcept { return static_cast<std::size_t>(num_nodes() * V); }

  /// out = m v + K v, so with weights times dt the left side of an implicit step [kg m/s]. A node's sum is
  /// made in a fixed order: the same bits for any number of threads.
  /// @param mass of each node [kg]; none leaves m v out, and K v is the viscous force, reversed [N]
  void apply(std::span<const double> mass, std::span<const double> weights, std::span<const double> v,
             std::span<double> out) const noexcept;

  /// The same for the derivative of K(u) u along v, of which each cell has weight K v + coupling K u.
  /// Eq. (R134)
  void apply_tangent(std::span<const double> mass, std::span<const double> weights,
                     std::span<const double> couplings, std::span<const double> u, std::span<const double> v,
                     std::span<double> out) const noexcept;

  /// u_e . K v_e of each cell [1/s^2] for unit weight: with u = v the mean square of its shear rate.
  /// Eq. (R131)
  void products(std::span<const double> u, std::span<const double> v, std::span<double> out) const noexcept;

  /// The diagonal of K, num_nodes x V.
  void diagonal(std::span<const double> weights, std::span<double> out) const noexcept;

  /// A rate that no motion's decay exceeds [1/s]: explicit Euler is stable up to a step of 2 over it. For
  /// equal cells full of one material it is the largest rate itself in one dimension, 1.5 times that in two
  /// and three. Nodes without mass have no say; 0 if nothing is viscous.  Eq. (R135)
  [[nodiscard]] double largest_rate(std::span<const double> mass,
                                    std::span<const double> weights) const noexcept;

  /// The nodes at the corners of a cell.
  [[nodiscard]] std::array<Index, static_cast<std::size_t>(1) << D> corners(Index cell) const noexcept;

 private:
  static constexpr int num_corners = CellStiffness<D, V>::num_corners;
  static constexpr int size = CellStiffness<D, V>::size;
  using Element = Eigen::Matrix<double, size, 1, Eigen::DontAlign>;

  /// What a place along an axis is next to, in the numbering of nodes and of cells; -1: nothing.
  struct Place {
    std::array<Index, 3> node;  ///< below, here, above
    std::array<Index, 2> cell;  ///< below, above
  };

  /// Calls body(node, cell, corner of the cell that the node is) for each cell round each node.
  template <class Begin, class Body, class End>
  void for_each_neighbour(Begin&& begin, Body&& body, End&& end) const noexcept;
  template <class Load>
  void gather(std::span<const double> mass, std::span<const double> v, std::span<double> out,
              Load&& load) const noexcept;

  CartesianGrid<D> grid_;
  CellStiffness<D, V> cell_;
  Threads threads_;
  std::array<std::vector<Place>, static_cast<std::size_t>(D)> places_;          // of nodes, along each axis
  std::array<Matrix<size, V>, static_cast<std::size_t>(num_corners)> columns_;  // of cell_.matrix, by corner
};

}  // namespace scree::rheology
