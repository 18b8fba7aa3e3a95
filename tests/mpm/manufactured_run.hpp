#pragma once

#include "bodies.hpp"
#include "manufactured.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace scree::mpm {

/// What a step does beside its own passes.
struct Extras {
  Order order = Order::usl;
  Averaging averaging = {};
  int xpic_order = 0;
  Index points_per_axis = 2;  ///< of each cell at first
};

/// Half a swing of the unit square under a manufactured motion, points at their exact places at first. Points
/// have the velocity of half a step before and the deformation gradient of a whole step before, so that the
/// step, which updates stress, velocity and places in this order, is centred.
template <class Motion>
class ManufacturedRun {
 public:
  /// @param num_cells along each axis
  ManufacturedRun(const Motion& motion, Index num_cells, const AnyShape& shape, const AnyTransfer& rule,
                  const Extras& extras = {})
      : motion_{motion},
        num_steps_{static_cast<int>(
            std::ceil(duration * rubber.wave_speed() * static_cast<double>(num_cells) / courant))},
        dt_{duration / num_steps_} {
    const auto grid = cube<2>(num_cells, 1 / static_cast<double>(num_cells), false);
    auto particles = filled<2>(grid, extras.points_per_axis, rubber.density);
    stages_.stress = std::make_unique<StressUpdateBy<2, 2, NeoHookean>>(rubber, particles);
    stages_.transfer = make_transfer<2, 2>(shape, rule);
    stages_.order = extras.order;
    stages_.averaging = extras.averaging;
    if (extras.xpic_order > 0) stages_.xpic = make_xpic<2, 2>(shape, extras.xpic_order);
    stages_.boundaries.push_back(std::make_unique<BodyForceOf<Motion>>(motion, time_));
    for (int axis = 0; axis < 2; ++axis) {
      for (const Side side : {Side::low, Side::high}) {
        stages_.boundaries.push_back(make_wall<2>(Slip{}, axis, side));
      }
    }
    place(particles);
    state_ = std::make_unique<State<2, 2>>(start(std::move(particles), grid, stages_, {1}));
  }

  /// Largest root mean square of the points' distance from where they belong, over all steps [m].
  [[nodiscard]] double error() {
    return error([](const auto& one_step) { one_step(); });
  }

  /// The same, each step made by around(one_step), which may measure what it costs.
  template <class Around>
  [[nodiscard]] double error(Around&& around) {
    double worst = 0;
    for (int n = 0; n < num_steps_; ++n) {
      around([&] { advance(n); });
      worst = std::max(worst, distance((n + 1) * dt_));
    }
    return worst;
  }

 private:
  static constexpr double duration = 0.01;  // [s], pi/omega
  static constexpr double courant = 0.2;    // of sound: the error of time is small beside that of the mesh

  [[nodiscard]] static Vector<2> position(const Particles<2>& particles, Index p) {
    return {particles.position.component(0)[p], particles.position.component(1)[p]};
  }

  void advance(int n) {
    time_ = n * dt_;
    step(*state_, stages_, dt_, {1});
  }

  void place(Particles<2>& particles) {
    origins_.resize(static_cast<std::size_t>(particles.size()));
    for (Index p = 0; p < particles.size(); ++p) {
      const Vector<2> X = position(particles, p);
      origins_[static_cast<std::size_t>(particles.id.component(0)[p])] = X;
      const Vector<2> x = motion_.place(X, 0);
      const Vector<2> velocity = (x - motion_.place(X, -dt_)) / dt_;
      const Matrix<2> before = motion_.gradient(X, -dt_);
      const Matrix<2> now = motion_.gradient(X, 0);
      const Matrix<2> L = (now - before) / dt_ * before.inverse();
      // Stress that has a pass of its own comes last, if not first: what F and density are strained by, when.
      const bool is_last = stages_.order == Order::musl || stages_.averaging.is_on();
      const Matrix<2>& first = is_last ? now : before;
      particles.density.component(0)[p] /= (stages_.order == Order::usf ? before : now).determinant();
      for (int i = 0; i < 2; ++i) {
        particles.position.component(i)[p] = x[i];
        particles.velocity.component(i)[p] = velocity[i];
        for (int j = 0; j < 2; ++j) {
          particles.velocity_gradient.component(i + 2 * j)[p] = L(i, j);
          particles.column(static_cast<std::size_t>(2 * i + j)).component(0)[p] = first(i, j);
        }
      }
    }
  }

  [[nodiscard]] double distance(double t) const {
    const Particles<2>& particles = state_->particles;
    double sum = 0;
    for (Index p = 0; p < particles.size(); ++p) {
      if (!(particles.mass.component(0)[p] > 0)) continue;
      const Vector<2>& X = origins_[static_cast<std::size_t>(particles.id.component(0)[p])];
      sum += (position(particles, p) - motion_.place(X, t)).squaredNorm();
    }
    return std::sqrt(sum / static_cast<double>(origins_.size()));
  }

  Motion motion_;
  int num_steps_;
  double dt_;
  double time_ = 0;
  Stages<2, 2> stages_;
  std::unique_ptr<State<2, 2>> state_;
  std::vector<Vector<2>> origins_;  // by id [m]
};

/// Errors on meshes of `coarsest`, twice, .. cells along each axis [m].
template <std::size_t num_meshes, class Motion>
[[nodiscard]] std::array<double, num_meshes> manufactured_errors(const Motion& motion, Index coarsest,
                                                                 const AnyShape& shape,
                                                                 const AnyTransfer& rule,
                                                                 const Extras& extras = {}) {
  std::array<double, num_meshes> errors{};
  for (std::size_t i = 0; i < num_meshes; ++i) {
    errors[i] = ManufacturedRun<Motion>{motion, coarsest << i, shape, rule, extras}.error();
  }
  return errors;
}

}  // namespace scree::mpm
