#pragma once

#include <scree/error.hpp>
#include <scree/rheology_stiff/implicit_viscosity.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace scree::rheology::test {

inline constexpr double pi = std::numbers::pi;

inline std::size_t at(Index i) {
  return static_cast<std::size_t>(i);
}

/// A unit cube of n cells along each axis.
template <int D>
CartesianGrid<D> cube(Index n, bool is_periodic) {
  Indices<D> num_cells;
  num_cells.fill(n);
  std::array<bool, D> periodic;
  periodic.fill(is_periodic);
  return {Vector<D>::Zero(), Vector<D>::Constant(1 / static_cast<double>(n)), num_cells, periodic};
}

/// Mass of each node of a grid that is full of one material [kg].
template <int D>
std::vector<double> full(const CartesianGrid<D>& grid, double density) {
  std::vector<double> mass;
  const Lattice<D> nodes = grid.nodes();
  for (Index i = 0; i < nodes.num_sites(); ++i) mass.push_back(density * nodes.volume(nodes.site(i)));
  return mass;
}

/// Numbers between low and high, always the same.
inline std::vector<double> random_values(std::size_t count, double low, double high) {
  std::mt19937 generator{20150904};
  std::uniform_real_distribution<double> between{low, high};
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(between(generator));
  return values;
}

/// Values of nodes, V components each, from their positions.
template <int V, int D, class Function>
std::vector<double> values_at_nodes(const CartesianGrid<D>& grid, Function&& function) {
  std::vector<double> values;
  const Lattice<D> nodes = grid.nodes();
  for (Index i = 0; i < nodes.num_sites(); ++i) {
    const Vector<V> v = function(nodes.position(nodes.site(i)));
    for (int k = 0; k < V; ++k) values.push_back(v[k]);
  }
  return values;
}

/// All components of the nodes on the low end of the last axis.
template <int V, int D>
std::vector<std::uint8_t> held_floor(const CartesianGrid<D>& grid) {
  std::vector<std::uint8_t> held;
  const Lattice<D> nodes = grid.nodes();
  for (Index i = 0; i < nodes.num_sites(); ++i) {
    for (int k = 0; k < V; ++k) held.push_back(nodes.site(i)[at(D - 1)] == 0 ? 1 : 0);
  }
  return held;
}

inline double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

inline double largest(const std::vector<double>& a) {
  double result = 0;
  for (const double x : a) result = std::max(result, std::abs(x));
  return result;
}

inline double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double result = 0;
  for (std::size_t i = 0; i < a.size(); ++i) result = std::max(result, std::abs(a[i] - b[i]));
  return result;
}

template <class Exception, class Body>
std::string message_of(Body&& body) {
  try {
    body();
  } catch (const Exception& exception) {
    return exception.what();
  }
  return "nothing was thrown";
}

}  // namespace scree::rheology::test
