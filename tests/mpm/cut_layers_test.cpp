// Layers that slide along a wall with friction, which cuts shape functions off, through many steps.

#include "cut_layers.hpp"

#include "schemes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <random>
#include <utility>
#include <variant>
#include <vector>

namespace scree::mpm {
namespace {

/// What a step makes of the shear rate of one layer, `place` spacings from the wall, where shapes are cut off
/// without (M183): sum of slope arm / weight over the nodes, each folded by (M26).  Eq. (M184)
[[nodiscard]] double predicted_growth(const AnyShape& any_shape, const AnyTransfer& rule, double place) {
  return std::visit(
      [&](const auto& shape) {
        const double base = std::floor(place - shape.shift);
        const double xi = place - base;
        const bool by_affine = std::visit([](const auto& one) { return one.has_affine_gradient; }, rule);
        const auto weight = shape.weights(xi);
        const auto slope = by_affine ? shape.affine(xi) : shape.gradients(xi);
        double sum = 0;
        const auto folded = [&](const auto& values, std::size_t i) {
          if (base >= 0) return values[i];
          return i == 1 ? values[1] + 2 * values[0] : i == 2 ? values[2] - values[0] : values[i];
        };
        auto arm = weight;
        for (std::size_t i = 0; i < shape.support; ++i) arm[i] *= static_cast<double>(i) - xi;
        for (std::size_t i = base < 0 ? 1 : 0; i < shape.support; ++i) {
          sum += folded(slope, i) * folded(arm, i) / folded(weight, i);
        }
        return sum;
      },
      any_shape);
}

/// The failure: by the sum of those squares, whatever the step, while no force acts. One of quadratic shapes'
/// layers at a sixth of a spacing grows by 9/5 a step.
TEST(CutShapes, ShearALayerApartIfAVelocityComesHomeFromTheImageAsItIs) {  // Eq. (M184)
  constexpr int num_steps = 25;
  for (const double place : {1.0 / 6, 0.3, 0.45}) {
    EXPECT_NEAR(predicted_growth(Quadratic{}, Apic{}, place), 1 / (4 * place * (1 - place)), 16 * round_off);
    for (const AnyShape& shape : every<AnyShape>()) {
      for (const AnyTransfer& rule : every<AnyTransfer>()) {
        if (!Scheme{shape, rule}.has_affine()) continue;
        const double expected = std::pow(predicted_growth(shape, rule, place), num_steps);
        Layers layer{{place}, shape, rule, true};
        layer.shear_rate(0) = 1;

        layer.advance(num_steps);

        EXPECT_NEAR(layer.shear_rate(0) / expected, 1, rounding_of(1, 4, num_steps))
            << Scheme{shape, rule}.name();
      }
    }
  }
}

TEST(CutShapes, LeaveALayerItsShear) {  // the remedy, Eq. (M183)
  constexpr int num_steps = 25;
  for (const double place : {1e-3, 1.0 / 6, 0.3, 0.45, 0.8}) {
    for (const AnyShape& shape : every<AnyShape>()) {
      for (const AnyTransfer& rule : every<AnyTransfer>()) {
        if (!Scheme{shape, rule}.has_affine()) continue;
        Layers layer{{place}, shape, rule, false};
        layer.shear_rate(0) = 1;

        layer.advance(num_steps);

        // What is light is the difference of two nodes that are not: rounded by weight / place.
        EXPECT_NEAR(layer.shear_rate(0), 1, rounding_of(1, 4, num_steps) / place)
            << Scheme{shape, rule}.name();
      }
    }
  }
}

/// Three cells deep it is slower; the rates are the largest eigenvalues of a step as a matrix, computed
/// apart.
TEST(CutShapes, ShearADeepBedApartTooIfAVelocityComesHomeAsItIs) {
  std::vector<double> places;
  places.reserve(9);
  for (int i = 0; i < 9; ++i) places.push_back((i + 0.5) / 3);
  const std::vector<std::pair<AnyShape, double>> cases{{Quadratic{}, 1.036136638}, {Cubic{}, 1.079245793}};
  for (const auto& [shape, rate] : cases) {
    for (const bool cuts_alone : {true, false}) {
      Layers bed{places, shape, Apic{}, cuts_alone};
      bed.shear_rate(0) = 1;
      bed.advance(600);
      const double before = bed.shear_rate(0);

      bed.advance(10);

      const double growth = std::pow(bed.shear_rate(0) / before, 0.1);
      if (cuts_alone) {
        EXPECT_NEAR(growth, rate, 1e-6) << Scheme{shape, Apic{}}.name();
      } else {
        EXPECT_LE(growth, 1 + 1e-6) << Scheme{shape, Apic{}}.name();
      }
    }
  }
}

/// Second moment of the weights of a point `place` spacings from the wall, cut off.
[[nodiscard]] double cut_moment(const AnyShape& any_shape, double place) {
  return std::visit(
      [&](const auto& shape) {
        const double base = std::floor(place - shape.shift);
        const double moment = shape.second_moment(place - base);
        return base < 0 ? moment - 2 * shape.weights(place - base)[0]
                        : moment;  // (1 + s)^2 becomes 2 s^2 - (1 - s)^2
      },
      any_shape);
}

/// Velocities go to the nodes as means and come back as projections onto affine ones: neither adds to
/// sum m (v^2 + M' L^2), with the second moment M' of the weights that are cut off.
TEST(CutShapes, GiveNoEnergyOfShear) {  // Eq. (M185)
  std::mt19937 random{5};
  std::uniform_real_distribution<double> draw{0, 1};
  for (const AnyShape& shape : {AnyShape{Quadratic{}}, AnyShape{Cubic{}}, AnyShape{Gimp{3}}}) {
    for (int trial = 0; trial < 50; ++trial) {
      std::vector<double> places;
      places.reserve(5);
      for (int p = 0; p < 5; ++p) places.push_back(0.01 + 1.5 * draw(random));
      Layers layers{places, shape, Apic{}, false};
      Particles<1, 2>& particles = layers.state.particles;
      fill_at_random(particles.velocity, 1);
      for (Index p = 0; p < particles.size(); ++p) {
        particles.velocity.component(0)[p] = 0;
        layers.shear_rate(p) = (2 * draw(random) - 1) / Layers::h;
      }
      const auto energy = [&] {
        double sum = 0;
        for (Index p = 0; p < particles.size(); ++p) {
          const double v = particles.velocity.component(1)[p];
          const double spin = Layers::h * layers.shear_rate(p);
          const double place = particles.position.component(0)[p] / Layers::h;
          sum += particles.mass.component(0)[p] * (v * v + cut_moment(shape, place) * spin * spin);
        }
        return sum;
      };
      double before = energy();
      for (int n = 0; n < 20; ++n) {
        layers.advance(1);
        const double after = energy();
        EXPECT_LE(after, before * (1 + rounding_of(1, 3, 1) / 0.01));  // as rounded beside the wall
        before = after;
      }
    }
  }
}

/// A transfer that leaves gradients as its kernels take them.
class Unmended final : public Transfer<1, 2> {
 public:
  explicit Unmended(std::unique_ptr<Transfer<1, 2>> whole) : whole_{std::move(whole)} {}
  [[nodiscard]] NodeRecord record() const noexcept override { return whole_->record(); }
  [[nodiscard]] double stencil_shift() const noexcept override { return whole_->stencil_shift(); }
  [[nodiscard]] Index tile_edge() const noexcept override { return whole_->tile_edge(); }
  void scatter(const Particles<1, 2>& particles, const ParticleBlock<1>& block, Nodes<1>& nodes,
               double dt) const noexcept override {
    whole_->scatter(particles, block, nodes, dt);
  }
  void scatter_cut(const Particles<1, 2>& particles, const ParticleBlock<1>& block, Nodes<1>& nodes,
                   const MeshEnd& end, double dt) const noexcept override {
    whole_->scatter_cut(particles, block, nodes, end, dt);
  }
  [[nodiscard]] BlockMotion gather(Particles<1, 2>& particles, const ParticleBlock<1>& block,
                                   const Nodes<1>& nodes, double dt) const noexcept override {
    return whole_->gather(particles, block, nodes, dt);
  }
  [[nodiscard]] bool gathers_cut() const noexcept override { return false; }
  void gather_cut(Particles<1, 2>& /*particles*/, const ParticleBlock<1>& /*block*/,
                  const Nodes<1>& /*nodes*/, const MeshEnd& /*end*/, const double* /*position*/,
                  double /*dt*/) const noexcept override {}

 private:
  std::unique_ptr<Transfer<1, 2>> whole_;
};

/// Three layers of a few: no other that a search found, of as many at hundredths of a cell, grows faster. The
/// rate is the largest eigenvalue of a step as a matrix, computed apart; beside it are one, twice, of an
/// affine velocity, and ones below.
TEST(CutShapes, ShearStrayLayersApartUnderCubicShapesIfGradientsAreNotMended) {  // Eq. (M197)
  constexpr double rate = 1 + 1.011106301e-4;
  constexpr int num_steps = 10000;
  for (const AnyTransfer& rule : {AnyTransfer{Apic{}}, AnyTransfer{Aflip{0}}}) {
    for (const bool is_mended : {false, true}) {
      Layers layers{{0.09, 2.73, 4.80}, Cubic{}, rule, false};
      if (!is_mended) {
        layers.stages.transfer = std::make_unique<Unmended>(std::move(layers.stages.transfer));
      }
      layers.shear_rate(0) = 1;
      std::array<double, 4> after{};
      for (double& shear : after) {
        layers.advance(num_steps);
        shear = layers.shear_rate(0);
      }

      const double growth = (after[3] - after[2]) / (after[2] - after[1]);
      if (is_mended) {  // what is not affine dies out
        EXPECT_LT(std::abs(after[3] - after[2]), std::abs(after[2] - after[1]));
        EXPECT_LE(std::abs(after[3]), 1);
      } else {  // ten digits of the rate, which the roundings of as many steps do not reach
        EXPECT_NEAR(std::pow(growth, 1.0 / num_steps), rate, 1e-10);
        EXPECT_GT(std::abs(after[3] - after[2]), 2 * std::abs(after[2] - after[1]));
      }
    }
  }
}

}  // namespace
}  // namespace scree::mpm
