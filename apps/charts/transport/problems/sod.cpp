#include "../problems.hpp"
#include "gas.hpp"
#include "lines.hpp"

#include <cmath>

namespace scree::charts {
namespace {

constexpr double gamma = 1.4;
constexpr double duration = 0.2;
constexpr Gas left{1, 0, 1};
constexpr Gas right{0.125, 0, 0.1};

/// Exact solution of Sod's problem: a rarefaction to the left, a contact, a shock to the right.
class SodSolution {
 public:
  SodSolution() {
    double low = right.pressure;
    double high = left.pressure;
    for (int halving = 0; halving < 60; ++halving) {
      pressure_ = (low + high) / 2;
      (behind_rarefaction(pressure_) > behind_shock(pressure_) ? low : high) = pressure_;
    }
    velocity_ = behind_rarefaction(pressure_);
    density_left_ = left.density * std::pow(pressure_ / left.pressure, 1 / gamma);
    const double ratio = pressure_ / right.pressure;
    const double mu = (gamma - 1) / (gamma + 1);
    density_right_ = right.density * (ratio + mu) / (mu * ratio + 1);
  }

  /// Antiderivative of the density over x at the end: t (rho s - rho u) at s = x/t, as rho solves
  /// (rho u)' = s rho' and both sides of a jump agree.
  [[nodiscard]] double mass_below(double x) const noexcept {
    const double s = x / duration;
    const Gas gas = at(s);
    return duration * gas.density * (s - gas.velocity);
  }

 private:
  static double sound(double pressure, double density) { return std::sqrt(gamma * pressure / density); }

  static double behind_rarefaction(double pressure) {
    const double c = sound(left.pressure, left.density);
    return 2 * c / (gamma - 1) * (1 - std::pow(pressure / left.pressure, (gamma - 1) / (2 * gamma)));
  }

  static double behind_shock(double pressure) {
    const double inertia = right.density * ((gamma + 1) * pressure + (gamma - 1) * right.pressure) / 2;
    return (pressure - right.pressure) / std::sqrt(inertia);
  }

  [[nodiscard]] Gas at(double s) const noexcept {
    const double shock = velocity_ * density_right_ / (density_right_ - right.density);
    if (s >= shock) return right;
    if (s >= velocity_) return {density_right_, velocity_, pressure_};
    if (s >= velocity_ - sound(pressure_, density_left_)) return {density_left_, velocity_, pressure_};
    const double c = sound(left.pressure, left.density);
    if (s <= -c) return left;
    const double velocity = 2 / (gamma + 1) * (c + s);
    const double density = left.density * std::pow((velocity - s) / c, 2 / (gamma - 1));
    return {density, velocity, left.pressure * std::pow(density / left.density, gamma)};
  }

  double pressure_ = 0;
  double velocity_;
  double density_left_;
  double density_right_;
};

}  // namespace

std::vector<Record> sod(const Extent& extent) {
  const SodSolution solution;
  std::vector<Record> records;
  for (const Index n : doublings(50, 5, extent)) {
    GasCase problem = between_open_ends(line(n, -0.5, 0.5, false), duration);
    for (Index i = 0; i < n; ++i) append(problem.start, i < n / 2 ? left : right);
    problem.exact = averages(problem.grid.lattice(), [&](double x) { return solution.mass_below(x); });
    std::ranges::copy(run_gas("sod", n, problem, extent.effort), std::back_inserter(records));
  }
  return records;
}

}  // namespace scree::charts
