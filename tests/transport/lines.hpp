#pragma once

#include <scree/lattice.hpp>
#include <scree/transport/grids/cartesian.hpp>
#include <scree/transport/solver.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

namespace scree::transport::test {

inline constexpr double pi = std::numbers::pi;

/// n cells between two ends.
inline Lattice<1> line(Index n, double low, double high, bool is_periodic = true) {
  Lattice<1> lattice;
  lattice.count = {n};
  lattice.spacing[0] = (high - low) / static_cast<double>(n);
  lattice.first[0] = low + lattice.spacing[0] / 2;
  lattice.is_periodic = {is_periodic};
  return lattice;
}

/// n cells along each axis of the unit cube, periodic.
template <int D>
Lattice<D> cube(Index n) {
  Lattice<D> lattice;
  lattice.count.fill(n);
  lattice.spacing = Vector<D>::Constant(1.0 / static_cast<double>(n));
  lattice.first = lattice.spacing / 2;
  lattice.is_periodic.fill(true);
  return lattice;
}

/// Cell averages of a function from its antiderivative.
template <class Antiderivative>
std::vector<double> averages(const Lattice<1>& lattice, Antiderivative&& integral) {
  std::vector<double> u;
  for (Index i = 0; i < lattice.count[0]; ++i) {
    const double low = lattice.first[0] + (static_cast<double>(i) - 0.5) * lattice.spacing[0];
    u.push_back((integral(low + lattice.spacing[0]) - integral(low)) / lattice.spacing[0]);
  }
  return u;
}

/// A square of height 1 beside a sin^2 bump, N cells on [0, 1].
inline std::vector<double> square_and_bump(Index n) {
  std::vector<double> u;
  for (Index i = 0; i < n; ++i) {
    const double x = (static_cast<double>(i) + 0.5) / static_cast<double>(n);
    const double bump = 0.6 < x && x < 0.9 ? std::pow(std::sin(pi * (x - 0.6) / 0.3), 2) : 0.0;
    u.push_back(0.1 < x && x < 0.4 ? 1.0 : bump);
  }
  return u;
}

/// dx * sum |a - b|.
inline double l1(const std::vector<double>& a, const std::vector<double>& b, double dx) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
  return dx * sum;
}

inline double linf(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

/// Total variation round a period.
inline double total_variation(const std::vector<double>& u) {
  double sum = 0;
  for (std::size_t i = 0; i < u.size(); ++i) sum += std::abs(u[(i + 1) % u.size()] - u[i]);
  return sum;
}

/// The message of the Expected that `action` throws; empty if it throws none.
template <class Expected, class Action>
std::string message_of(Action&& action) {
  try {
    action();
  } catch (const Expected& error) {
    return error.what();
  }
  return {};
}

/// No limiter: half the sum of both differences. Second order, and not monotone.
struct Centred {
  static constexpr std::string_view name = "centred";
  static constexpr std::string_view summary = "no limiter";
  double operator()(double backward, double forward) const noexcept { return (backward + forward) / 2; }
  double sharpness() const noexcept { return 0; }
};

}  // namespace scree::transport::test
