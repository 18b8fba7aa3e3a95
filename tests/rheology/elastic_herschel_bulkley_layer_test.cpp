// The layer of mud on an incline, as it starts to flow and until it is steady: a plug that rides unsheared.

#include "points.hpp"

#include <scree/rheology/laws/elastic_herschel_bulkley.hpp>

#include <gtest/gtest.h>

#include <numbers>

namespace scree::rheology {
namespace {

using Mud = ElasticHerschelBulkley;

constexpr double drive = 1000 * 9.81 * 0.30901699437494742;  // rho g sin(18 degrees) [Pa/m], on 1 m

/// A layer of 1 m, from rest, in explicit steps; nodes from the base up.
class Layer {
 public:
  Layer(const Mud& law, std::size_t num_cells)
      : dx_{1.0 / static_cast<double>(num_cells)},
        dt_{0.9 * dx_ / std::sqrt(law.shear_modulus / law.density)},
        cells_(num_cells, Point<Mud>{law}),
        speeds_(num_cells + 1) {}

  /// @return the way of each node meanwhile [m]
  std::vector<double> advance(int num_steps) {
    std::vector<double> ways(speeds_.size());
    const std::size_t surface = cells_.size();
    const double density = cells_.front().law.density;
    for (int n = 0; n < num_steps; ++n) {
      for (std::size_t i = 0; i < surface; ++i) {
        cells_[i].step(simple_shear((speeds_[i + 1] - speeds_[i]) / dx_), density, dt_);
      }
      for (std::size_t i = 1; i <= surface; ++i) {
        const double above = i == surface ? 0 : cells_[i].stress(0, 1);
        const double mass = density * dx_ / (i == surface ? 2 : 1);
        speeds_[i] += dt_ * (drive / density + (above - cells_[i - 1].stress(0, 1)) / mass);
        ways[i] += dt_ * speeds_[i];
      }
    }
    return ways;
  }
  [[nodiscard]] double surface_speed() const { return speeds_.back(); }
  [[nodiscard]] double cell_width() const { return dx_; }
  [[nodiscard]] double step_length() const { return dt_; }

 private:
  double dx_;
  double dt_;
  std::vector<Point<Mud>> cells_;
  std::vector<double> speeds_;
};

/// The yield surface is at 0.6701255884 m and the plug moves at 0.9075540843 m/s. It is sheared by what its
/// elasticity lets it and no more, however long it flows; the regularised fluid's creeps by 3 mm/s at m = 100
/// s.
TEST(ElasticHerschelBulkleyLayer, MakesTheExactPlugOfBingham) {
  const Mud law{.consistency = 750,
                .exponent = 1,
                .yield_stress = 1000,
                .shear_modulus = 1e6,
                .bulk_modulus = 1e7,
                .density = 1000};
  Layer layer{law, 50};
  layer.advance(20000);  // 11.4 s; the slowest mode, the plug on the layer beneath, dies at 1.9/s

  const auto ways = layer.advance(10000);

  // The rate is piecewise linear in y: midpoint rule, off in the cell with the yield surface only. The stress
  // lags by tau/G. Strain that waves in the plug leave is elastic: from one yield to the other at most.
  const double time = 10000 * layer.step_length();
  const double quadrature = std::pow(layer.cell_width(), 2) * drive / (8 * law.consistency);
  const double lag = std::pow(drive / law.shear_modulus, 2);
  const double elastic = 2 * law.yield_stress / law.shear_modulus;
  EXPECT_NEAR(ways.back() / time, 0.9075540843, quadrature + lag + elastic * (1 - 0.67) / time);
  for (std::size_t i = 34; i < 50; ++i) {
    EXPECT_LE(std::abs(ways.back() - ways[i]), elastic * (1 - static_cast<double>(i) / 50)) << i;
  }
  EXPECT_GT(ways.back() - ways[32], 1e-3 * time);  // 0.64 m: beneath, where it flows
}

/// Huang & Garcia (1998): the sheet of mud with n = 1/2; u = n/(n+1) (drive/K)^(1/n) y_y^(1+1/n) for the
/// plug. \cite huang1998
TEST(ElasticHerschelBulkleyLayer, MakesTheSheetOfHerschelAndBulkley) {
  const Mud law{.consistency = 1000,
                .exponent = 0.5,
                .yield_stress = 1000,
                .shear_modulus = 1e6,
                .bulk_modulus = 1e7,
                .density = 1000};
  const double yield_surface = 1 - law.yield_stress / drive;
  const double slope = std::pow(drive / law.consistency, 2);  // rate = slope (y_y - y)^2
  const double exact = slope * std::pow(yield_surface, 3) / 3;
  Layer layer{law, 25};
  layer.advance(15000);  // 17 s; the slowest mode dies at 1.05/s

  const auto ways = layer.advance(5000);

  // Midpoint rule: dx^2/24 times the change of the slope of the rate, and the cell with the yield surface.
  const double dx = layer.cell_width();
  const double time = 5000 * layer.step_length();
  const double quadrature = dx * dx / 24 * 2 * slope * yield_surface + slope * dx * dx * dx;
  const double lag = 3 * std::pow(drive / law.shear_modulus, 2);
  const double elastic = 2 * law.yield_stress / law.shear_modulus * (1 - yield_surface) / time;
  EXPECT_NEAR(ways.back() / time, exact, quadrature + lag * exact + elastic);
}

/// On a slope that its yield stress bears the layer does not flow at all: it swings about its elastic rest,
/// by drive/(2 G) at the surface, for ever.
TEST(ElasticHerschelBulkleyLayer, RestsOnASlopeThatItsYieldStressBears) {
  const Mud law{.consistency = 750,
                .exponent = 1,
                .yield_stress = 2.1 * drive,  // the swing reaches twice the stress of rest
                .shear_modulus = 1e7,
                .bulk_modulus = 1e7,
                .density = 1000};
  Layer layer{law, 20};
  const double rest = drive / (2 * law.shear_modulus);  // [m]
  double way = 0;
  for (int n = 0; n < 20000; ++n) {
    way += layer.advance(1).back();
    // The waves of cells are slower than those of the continuum by (pi dx)^2/96 of the longest, and the step
    // lets it swing wider by as little.
    EXPECT_GE(way, -0.1 * rest);
    EXPECT_LE(way, 2.1 * rest);
  }
}

}  // namespace
}  // namespace scree::rheology
