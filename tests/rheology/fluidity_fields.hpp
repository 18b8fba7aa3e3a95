#pragma once

#include <scree/rheology/fluidity_grid.hpp>

#include <algorithm>
#include <vector>

namespace scree::rheology {

/// A box of `count` cells of edge h along each axis.
template <int D>
[[nodiscard]] Lattice<D> cells_of(const Indices<D>& count, double h, bool is_periodic = false) {
  std::array<bool, static_cast<std::size_t>(D)> periodic{};
  periodic.fill(is_periodic);
  return CartesianGrid<D>{Vector<D>::Zero(), Vector<D>::Constant(h), count, periodic}.cells();
}

/// Fields that a test owns, uniform at first.
struct OwnedFields {
  std::vector<double> friction;
  std::vector<double> pressure;
  std::vector<double> grain_size;

  OwnedFields(Index num_cells, double mu, double p = 500, double size = 1e-3)
      : friction(static_cast<std::size_t>(num_cells), mu),
        pressure(friction.size(), p),
        grain_size(friction.size(), size) {}
  [[nodiscard]] FluidityFields view() const { return {friction, pressure, grain_size}; }
};

template <int D>
[[nodiscard]] FluidityGrid<D> grid_of(const NonlocalFluidity& model, const Lattice<D>& cells,
                                      const FluidityEnds<D>& ends) {
  return {model, cells, std::vector<bool>(static_cast<std::size_t>(cells.num_sites()), true), ends};
}

/// The steady fluidity of a box that is full.
template <int D>
[[nodiscard]] std::vector<double> steady(const NonlocalFluidity& model, const Lattice<D>& cells,
                                         const FluidityEnds<D>& ends, const OwnedFields& fields) {
  std::vector<double> g(static_cast<std::size_t>(cells.num_sites()));
  grid_of<D>(model, cells, ends).solve_steady(fields.view(), g);
  return g;
}

[[nodiscard]] inline double largest(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

}  // namespace scree::rheology
