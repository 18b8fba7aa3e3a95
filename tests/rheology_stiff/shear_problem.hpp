#pragma once

#include "bodies.hpp"

namespace scree::rheology::test {

/// Iterations of conjugate gradients for one long step, nu dt = 1 m^2 on the unit cube: a body that slides on
/// its floor and wobbles.
template <int D>
long shear_iterations(Index n, ViscousPreconditioner preconditioner, bool is_periodic = false) {
  Indices<D> num_cells;
  num_cells.fill(n);
  std::array<bool, D> periodic{};
  if (D > 1) periodic[0] = is_periodic;
  const CartesianGrid<D> grid{Vector<D>::Zero(), Vector<D>::Constant(1 / static_cast<double>(n)), num_cells,
                              periodic};
  constexpr int V = D == 1 ? 2 : D;
  const auto held = held_floor<V>(grid);
  auto v = values_at_nodes<V>(grid, [](const Vector<D>& x) {
    Vector<V> velocity = Vector<V>::Constant(0.1 * std::sin(7 * x.sum()));
    velocity[0] += 1;
    return velocity;
  });
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = held[i] != 0 ? 0 : v[i];
  ImplicitViscosity<D, V> solver{grid, {.preconditioner = preconditioner, .largest_linear = 5000}};
  const std::vector<double> viscosity(at(grid.cells().num_sites()), 1.0);
  return solver.advance(v, {full(grid, 1), held}, viscosity, 1).linear_iterations;
}

}  // namespace scree::rheology::test
