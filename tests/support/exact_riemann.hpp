#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace scree::testing {

/// The root of a function that rises, between two points with the root between them; halved until no double
/// lies between.
template <class Function>
double rising_root(double low, double high, Function&& function) {
  for (;;) {
    const double middle = 0.5 * (low + high);
    if (!(low < middle && middle < high)) return middle;
    (function(middle) < 0 ? low : high) = middle;
  }
}

/// One side of a Riemann problem of a gas.
struct Gas {
  double density;
  double velocity;
  double pressure;
};

/// Exact solution of the Riemann problem of an ideal gas, vacuum between two fans included (Toro 2009, ch.
/// 4).
class GasRiemann {
 public:
  GasRiemann(const Gas& left, const Gas& right, double gamma = 1.4)
      : left_{left}, right_{right}, gamma_{gamma} {
    const double apart = right.velocity - left.velocity;
    has_vacuum_ = apart >= 2 / (gamma - 1) * (sound(left) + sound(right));
    if (has_vacuum_) return;
    const auto sum = [&](double p) { return rise(p, left_) + rise(p, right_) + apart; };
    double high = std::max(left.pressure, right.pressure);
    while (sum(high) < 0) high *= 2;
    star_pressure_ = rising_root(0, high, sum);
    star_velocity_ = 0.5 * (left.velocity + right.velocity) +
                     0.5 * (rise(star_pressure_, right_) - rise(star_pressure_, left_));
  }

  [[nodiscard]] double star_pressure() const { return star_pressure_; }
  [[nodiscard]] double star_velocity() const { return star_velocity_; }
  [[nodiscard]] double star_density_left() const { return star_density(left_); }
  [[nodiscard]] double star_density_right() const { return star_density(right_); }

  /// On the ray x/t = s.
  [[nodiscard]] Gas at(double s) const {
    const bool is_left =
        has_vacuum_ ? s < left_.velocity + 2 / (gamma_ - 1) * sound(left_) : s < star_velocity_;
    if (is_left) return on_left(left_, s);
    const Gas mirrored = on_left({right_.density, -right_.velocity, right_.pressure}, -s);
    return {mirrored.density, -mirrored.velocity, mirrored.pressure};
  }

  /// The rays where the solution jumps or has a corner.
  [[nodiscard]] std::vector<double> breaks() const {
    std::vector<double> rays{star_velocity_};
    for (const double sign : {1.0, -1.0}) {
      const Gas& side = sign > 0 ? left_ : right_;
      const Gas seen{side.density, sign * side.velocity, side.pressure};
      for (const double ray : edges_on_left(seen)) rays.push_back(sign * ray);
    }
    return rays;
  }

 private:
  [[nodiscard]] double sound(const Gas& gas) const { return std::sqrt(gamma_ * gas.pressure / gas.density); }

  /// Change of velocity across the wave to a pressure.
  [[nodiscard]] double rise(double p, const Gas& side) const {
    if (p > side.pressure) {
      const double a = 2 / ((gamma_ + 1) * side.density);
      const double b = (gamma_ - 1) / (gamma_ + 1) * side.pressure;
      return (p - side.pressure) * std::sqrt(a / (p + b));
    }
    return 2 * sound(side) / (gamma_ - 1) * (std::pow(p / side.pressure, (gamma_ - 1) / (2 * gamma_)) - 1);
  }

  [[nodiscard]] double star_density(const Gas& side) const {
    const double ratio = star_pressure_ / side.pressure;
    const double g = (gamma_ - 1) / (gamma_ + 1);
    return side.density * (ratio > 1 ? (ratio + g) / (g * ratio + 1) : std::pow(ratio, 1 / gamma_));
  }

  /// Head and tail of the wave that runs to the left into `side`; both the same for a shock.
  [[nodiscard]] std::array<double, 2> edges_on_left(const Gas& side) const {
    const double c = sound(side);
    if (has_vacuum_) return {side.velocity - c, side.velocity + 2 / (gamma_ - 1) * c};
    const double ratio = star_pressure_ / side.pressure;
    if (ratio > 1) {
      const double speed =
          side.velocity - c * std::sqrt((gamma_ + 1) / (2 * gamma_) * ratio + (gamma_ - 1) / (2 * gamma_));
      return {speed, speed};
    }
    const double star_velocity = side.velocity - rise(star_pressure_, side);
    return {side.velocity - c, star_velocity - c * std::pow(ratio, (gamma_ - 1) / (2 * gamma_))};
  }

  /// Left of the contact, `side` being what is on the left.
  [[nodiscard]] Gas on_left(const Gas& side, double s) const {
    const auto [head, tail] = edges_on_left(side);
    if (s <= head) return side;
    if (s >= tail) {
      if (has_vacuum_) return {0, 0, 0};
      return {star_density(side), side.velocity - rise(star_pressure_, side), star_pressure_};
    }
    const double c = sound(side);
    const double scale = 2 / (gamma_ + 1) + (gamma_ - 1) / ((gamma_ + 1) * c) * (side.velocity - s);
    return {side.density * std::pow(scale, 2 / (gamma_ - 1)),
            2 / (gamma_ + 1) * (c + (gamma_ - 1) / 2 * side.velocity + s),
            side.pressure * std::pow(scale, 2 * gamma_ / (gamma_ - 1))};
  }

  Gas left_;
  Gas right_;
  double gamma_;
  bool has_vacuum_ = false;
  double star_pressure_ = 0;
  double star_velocity_ = 0;
};

/// One side of a dam.
struct Water {
  double depth;
  double velocity;
};

/// Exact solution of the Riemann problem of shallow water with a wet bed on the left; the bed on the right
/// may be dry (Ritter 1892; Stoker 1957).
class WaterRiemann {
 public:
  WaterRiemann(const Water& left, const Water& right, double gravity)
      : left_{left}, right_{right}, gravity_{gravity} {
    if (right.depth == 0) return;
    const double apart = right.velocity - left.velocity;
    const auto sum = [&](double h) { return rise(h, left_) + rise(h, right_) + apart; };
    double high = std::max(left.depth, right.depth);
    while (sum(high) < 0) high *= 2;
    star_depth_ = rising_root(0, high, sum);
    star_velocity_ = left.velocity - rise(star_depth_, left_);
  }

  [[nodiscard]] double star_depth() const { return star_depth_; }
  [[nodiscard]] double star_velocity() const { return star_velocity_; }

  [[nodiscard]] Water at(double s) const {
    if (right_.depth == 0) {
      return s < left_.velocity + 2 * wave(left_) ? on_left(left_, s) : Water{0, 0};
    }
    if (s < star_velocity_) return on_left(left_, s);
    const Water mirrored = on_left({right_.depth, -right_.velocity}, -s);
    return {mirrored.depth, -mirrored.velocity};
  }

  [[nodiscard]] std::vector<double> breaks() const {
    const auto left = edges_on_left(left_);
    std::vector<double> rays{left[0], left[1]};
    if (right_.depth == 0) return rays;
    for (const double ray : edges_on_left({right_.depth, -right_.velocity})) rays.push_back(-ray);
    return rays;
  }

 private:
  [[nodiscard]] double wave(const Water& side) const { return std::sqrt(gravity_ * side.depth); }

  [[nodiscard]] double rise(double h, const Water& side) const {
    if (h > side.depth) return (h - side.depth) * std::sqrt(gravity_ / 2 * (1 / h + 1 / side.depth));
    return 2 * (std::sqrt(gravity_ * h) - wave(side));
  }

  [[nodiscard]] std::array<double, 2> edges_on_left(const Water& side) const {
    const double c = wave(side);
    if (right_.depth == 0) return {side.velocity - c, side.velocity + 2 * c};
    if (star_depth_ > side.depth) {
      const double ratio = star_depth_ / side.depth;
      const double speed = side.velocity - c * std::sqrt(ratio * (ratio + 1) / 2);
      return {speed, speed};
    }
    return {side.velocity - c, side.velocity - rise(star_depth_, side) - std::sqrt(gravity_ * star_depth_)};
  }

  [[nodiscard]] Water on_left(const Water& side, double s) const {
    const auto [head, tail] = edges_on_left(side);
    if (s <= head) return side;
    if (s >= tail) return {star_depth_, side.velocity - rise(star_depth_, side)};
    const double c = (side.velocity + 2 * wave(side) - s) / 3;
    return {c * c / gravity_, s + c};
  }

  Water left_;
  Water right_;
  double gravity_;
  double star_depth_ = 0;
  double star_velocity_ = 0;
};

/// Averages over n cells from `low` on, of a quantity of a solution that depends on x/t: by five Gauss points
/// on each piece between its breaks.
/// @param quantity of what solution.at() returns.
template <class Solution, class Quantity>
std::vector<double> fan_averages(const Solution& solution, double time, std::ptrdiff_t n, double low,
                                 double dx, Quantity&& quantity) {
  const double inner = std::sqrt(5 - 2 * std::sqrt(10.0 / 7)) / 3;
  const double outer = std::sqrt(5 + 2 * std::sqrt(10.0 / 7)) / 3;
  const double inner_weight = (322 + 13 * std::sqrt(70.0)) / 900;
  const double outer_weight = (322 - 13 * std::sqrt(70.0)) / 900;
  const std::array<double, 5> points{-outer, -inner, 0, inner, outer};
  const std::array<double, 5> weights{outer_weight, inner_weight, 128.0 / 225, inner_weight, outer_weight};
  std::vector<double> breaks;
  for (const double ray : solution.breaks()) breaks.push_back(ray * time);
  std::sort(breaks.begin(), breaks.end());
  std::vector<double> averages;
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const double begin = low + static_cast<double>(i) * dx;
    std::vector<double> ends{begin};
    for (const double x : breaks) {
      if (begin < x && x < begin + dx) ends.push_back(x);
    }
    ends.push_back(begin + dx);
    double integral = 0;
    for (std::size_t piece = 0; piece + 1 < ends.size(); ++piece) {
      const double half = (ends[piece + 1] - ends[piece]) / 2;
      for (std::size_t k = 0; k < 5; ++k) {
        integral += half * weights[k] * quantity(solution.at((ends[piece] + half + half * points[k]) / time));
      }
    }
    averages.push_back(integral / dx);
  }
  return averages;
}

}  // namespace scree::testing
