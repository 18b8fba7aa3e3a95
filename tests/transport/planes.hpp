#pragma once

#include "lines.hpp"

#include <scree/transport/reconstructions.hpp>

#include <array>

namespace scree::transport::test {

/// n x n cells on [low_x, low_x + width] x [low_y, low_y + width].
inline Lattice<2> square(Index n, double low_x, double low_y, double width, bool is_periodic = true) {
  Lattice<2> lattice;
  lattice.count = {n, n};
  lattice.spacing = Vector<2>::Constant(width / static_cast<double>(n));
  lattice.first = Vector<2>{low_x, low_y} + lattice.spacing / 2;
  lattice.is_periodic.fill(is_periodic);
  return lattice;
}

/// Averages of sin x sin y.
inline std::vector<double> sine_averages(const Lattice<2>& lattice) {
  const double h = lattice.spacing[0] / 2;
  const double damping = std::pow(std::sin(h) / h, 2);
  std::vector<double> u;
  for (Index site = 0; site < lattice.num_sites(); ++site) {
    const Vector<2> x = lattice.position(lattice.site(site));
    u.push_back(damping * std::sin(x[0]) * std::sin(x[1]));
  }
  return u;
}

/// Averages of the solution of Burgers' equation (f = u^2/2 along both axes) from 0.5 + sin(pi (x + y)/2) on
/// [-2, 2]^2, before its shock at T = 1/pi: functions of x + y alone.
inline std::vector<double> burgers_averages(const Lattice<2>& lattice, double time) {
  const auto at = [&](double s) {  // u(s) = start(s - 2 u t), by Newton's method
    double u = 0.5;
    for (int i = 0; i < 60; ++i) {
      const double angle = pi / 2 * (s - 2 * u * time);
      u -= (u - 0.5 - std::sin(angle)) / (1 + pi * time * std::cos(angle));
    }
    return u;
  };
  constexpr std::array<double, 3> points{-0.7745966692414834, 0, 0.7745966692414834};  // Gauss, on [-1, 1]
  constexpr std::array<double, 3> weights{5.0 / 18, 8.0 / 18, 5.0 / 18};
  const double h = lattice.spacing[0] / 2;
  std::vector<double> of_sum;  // by i + j
  for (Index sum = 0; sum < 2 * lattice.count[0]; ++sum) {
    const double s = lattice.first.sum() + static_cast<double>(sum) * lattice.spacing[0];
    double average = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j)
        average += weights[i] * weights[j] * at(s + h * (points[i] + points[j]));
    }
    of_sum.push_back(average);
  }
  std::vector<double> u;
  for (Index site = 0; site < lattice.num_sites(); ++site) {
    const auto [i, j] = lattice.site(site);
    u.push_back(of_sum[static_cast<std::size_t>(i + j)]);
  }
  return u;
}

}  // namespace scree::transport::test
