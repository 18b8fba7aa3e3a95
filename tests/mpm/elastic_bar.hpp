#pragma once

#include "bodies.hpp"
#include "neo_hookean.hpp"

#include <algorithm>
#include <array>
#include <complex>
#include <memory>
#include <numbers>
#include <utility>
#include <variant>
#include <vector>

namespace scree::mpm {

/// A bar of 1 m between rigid walls, `num_points` regular points in each cell, with a standing wave of
/// compression v = v_0 sin(k x), k = pi m: by theory, and in the mesh.
struct BarWave {
  static constexpr NeoHookean solid{.lambda = 1.2e5, .mu = 0.6e5, .density = 1000};
  static constexpr double velocity = 1e-8;  ///< over the speed of sound [-]: as good as linear
  static constexpr std::size_t num_points = 2;

  AnyShape shape;
  AnyTransfer rule;
  Index num_cells;
  int half_waves;  ///< m
  double courant;  ///< of sound
  Order order = Order::usl;
  int xpic_order = 0;
  double drift = 0;   ///< of all points through the mesh [spacings per step]
  double offset = 0;  ///< of all points at first [spacings]

  [[nodiscard]] double spacing() const { return 1 / static_cast<double>(num_cells); }
  [[nodiscard]] double wave_number() const { return std::numbers::pi * half_waves; }
  [[nodiscard]] double dt() const { return courant * spacing() / solid.wave_speed(); }
};

/// The wave of a `BarWave` on one family of points, those at one place of their cells; complex amplitudes of
/// e^(i k x), lengths in spacings, times in steps, velocities in v_0.
struct PointFamily {
  std::complex<double> value;     ///< sum_j w_j e^(i k (x_j - x_p)): what a nodal wave is at the point
  std::complex<double> slope;     ///< the same with what gathers the velocity gradient, Eq. (M10)
  std::complex<double> moment;    ///< the same with w_j (x_j - x_p)
  std::complex<double> velocity;  ///< of the points
  std::complex<double> gradient;  ///< L
  std::complex<double> strain;
};

/// What a step makes of a plane wave of small amplitude on points that stay where they are, or all move on
/// alike: the step of docs/schemes/mpm_verification.md written for one wave.  Eqs. (M85), (M192)
class WaveRecursion {
 public:
  explicit WaveRecursion(const BarWave& wave) : wave_{wave}, phase_{wave.wave_number() * wave.spacing()} {
    for (PointFamily& family : families_) {
      family.velocity = 1;
      family.gradient = std::complex<double>{0, phase_};
    }
    place_families();
  }

  void advance() {
    const std::complex<double> before = scattered();
    const auto filtered = changes_by_filter();
    std::complex<double> force = 0;
    for (PointFamily& family : families_) {
      if (wave_.order == Order::usl) family.strain += family.gradient;
      if (wave_.order == Order::usf) family.strain += family.slope * before;
      force -= std::conj(family.slope) * family.strain / double{BarWave::num_points};
    }
    const std::complex<double> increment = wave_.courant * wave_.courant * force;
    const std::complex<double> after = before + increment;
    for (std::size_t i = 0; i < BarWave::num_points; ++i) {
      PointFamily& family = families_[i];
      family.gradient = family.slope * after;
      const double share = share_of_increment();
      family.velocity = share * (family.velocity + family.value * increment) +
                        (1 - share) * family.value * after + filtered[i];
    }
    if (wave_.order == Order::musl) {
      const std::complex<double> mapped = scattered();
      for (PointFamily& family : families_) family.strain += family.slope * mapped;
    }
    ++num_steps_;
    if (wave_.drift != 0) place_families();
  }

  /// Velocity of a point, its family known from its place [v_0].
  [[nodiscard]] double velocity_at(double x) const {
    const double along = x / wave_.spacing();
    const auto i = static_cast<std::size_t>((along - std::floor(along)) * BarWave::num_points);
    return std::imag(families_[i].velocity * std::polar(1.0, wave_.wave_number() * x));
  }

  /// Root mean square over a whole number of periods [v_0].
  [[nodiscard]] double size() const {
    double sum = 0;
    for (const PointFamily& family : families_) sum += std::norm(family.velocity);
    return std::sqrt(sum / (2 * BarWave::num_points));
  }

 private:
  [[nodiscard]] bool is_affine() const {
    return std::visit([](const auto& rule) { return rule.has_affine; }, wave_.rule);
  }
  [[nodiscard]] bool has_affine_gradient() const {
    return std::visit([](const auto& rule) { return rule.has_affine_gradient; }, wave_.rule);
  }
  [[nodiscard]] double share_of_increment() const {
    return std::visit([](const auto& rule) { return rule.increment_share(); }, wave_.rule);
  }

  /// What the filter takes from the velocities.  Eq. (M130)
  [[nodiscard]] std::array<std::complex<double>, BarWave::num_points> changes_by_filter() const {
    std::array<std::complex<double>, BarWave::num_points> left{};
    for (std::size_t i = 0; i < left.size(); ++i) left[i] = families_[i].velocity;
    for (int k = 0; k < wave_.xpic_order; ++k) {  // left <- (1 - S S+) left
      std::complex<double> mapped = 0;
      for (std::size_t i = 0; i < left.size(); ++i) {
        mapped += std::conj(families_[i].value) * left[i] / double{BarWave::num_points};
      }
      for (std::size_t i = 0; i < left.size(); ++i) left[i] -= families_[i].value * mapped;
    }
    for (auto& change : left) change = wave_.xpic_order > 0 ? -change : 0;
    return left;
  }

  /// Momentum over mass of the nodes.
  [[nodiscard]] std::complex<double> scattered() const {
    std::complex<double> sum = 0;
    for (const PointFamily& family : families_) {
      sum += std::conj(family.value) * family.velocity;
      if (is_affine()) sum += std::conj(family.moment) * family.gradient;
    }
    return sum / double{BarWave::num_points};
  }

  void place_families() {
    for (std::size_t i = 0; i < families_.size(); ++i) {
      place_family(families_[i], (static_cast<double>(i) + 0.5) / BarWave::num_points + wave_.offset +
                                     num_steps_ * wave_.drift);
    }
  }
  void place_family(PointFamily& family, double place) const {
    family.value = family.slope = family.moment = 0;
    std::visit(
        [&](auto shape) {
          using Shape = decltype(shape);
          const double base = std::floor(place - Shape::shift);
          const double xi = place - base;
          const auto weights = shape.weights(xi);
          const auto slopes = has_affine_gradient() ? shape.affine(xi) : shape.gradients(xi);
          for (std::size_t j = 0; j < Shape::support; ++j) {
            const double distance = static_cast<double>(j) - xi;
            const std::complex<double> turn = std::polar(1.0, phase_ * distance);
            family.value += weights[j] * turn;
            family.slope += slopes[j] * turn;
            family.moment += weights[j] * distance * turn;
          }
        },
        wave_.shape);
  }

  BarWave wave_;
  double phase_;  // k h
  int num_steps_ = 0;
  std::array<PointFamily, BarWave::num_points> families_{};
};

/// The same wave in the library; one that moves through the mesh goes round a period.
class BarInTheMesh {
 public:
  explicit BarInTheMesh(const BarWave& wave) : wave_{wave} {
    const auto grid = cube<1>(wave.num_cells, wave.spacing(), is_moving());
    auto particles = filled<1>(grid, BarWave::num_points, BarWave::solid.density);
    const double k = wave.wave_number();
    for (Index p = 0; p < particles.size(); ++p) {
      particles.position.component(0)[p] += wave.offset * wave.spacing();
      const double x = particles.position.component(0)[p];
      particles.velocity.component(0)[p] = drift() + unit() * std::sin(k * x);
      particles.velocity_gradient.component(0)[p] = unit() * k * std::cos(k * x);
    }
    stages_.stress = std::make_unique<StressUpdateBy<1, 1, NeoHookean>>(BarWave::solid, particles);
    stages_.transfer = make_transfer<1, 1>(wave.shape, wave.rule);
    stages_.order = wave.order;
    if (wave.xpic_order > 0) stages_.xpic = make_xpic<1, 1>(wave.shape, wave.xpic_order);
    for (const Side side : {Side::low, Side::high}) {
      if (!is_moving()) stages_.boundaries.push_back(make_wall<1>(NoSlip{}, 0, side));
    }
    state_ = std::make_unique<State<1, 1>>(start(std::move(particles), grid, stages_, {1}));
  }

  void advance() { step(*state_, stages_, wave_.dt(), {1}); }

  /// Calls visit(x, v over v_0) for every point.
  template <class Visit>
  void for_each_point(Visit&& visit) const {
    const auto& particles = state_->particles;
    for (Index p = 0; p < particles.size(); ++p) {
      if (!(particles.mass.component(0)[p] > 0)) continue;
      visit(particles.position.component(0)[p], (particles.velocity.component(0)[p] - drift()) / unit());
    }
  }

  /// Share of the wave in the points' velocities [v_0].
  [[nodiscard]] double amplitude() const {
    double sum = 0;
    double norm = 0;
    for_each_point([&](double x, double v) {
      const double mode = std::sin(wave_.wave_number() * x);
      sum += mode * v;
      norm += mode * mode;
    });
    return sum / norm;
  }

  /// Root mean square of v over v_0.
  [[nodiscard]] double size() const {
    double sum = 0;
    double count = 0;
    for_each_point([&](double /*x*/, double v) {
      sum += v * v;
      ++count;
    });
    return std::sqrt(sum / count);
  }

 private:
  [[nodiscard]] bool is_moving() const { return wave_.drift != 0; }
  [[nodiscard]] double drift() const { return wave_.drift * wave_.spacing() / wave_.dt(); }  // [m/s]
  [[nodiscard]] static double unit() { return BarWave::velocity * BarWave::solid.wave_speed(); }

  BarWave wave_;
  Stages<1, 1> stages_;
  std::unique_ptr<State<1, 1>> state_;
};

}  // namespace scree::mpm
