// From which step on waves grow in a layer thinner than a cell, shown by the step itself.

#include "growing_bar.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace scree::mpm {
namespace {

/// A layer of points on a wall without slip, under hat functions: one row of nodes moves. It is periodic
/// along the wall, with points in the middle of cells there.
template <int D>
struct LayerOnWall {
  AnyTransfer transfer;
  Order order;
  double thickness;  ///< [cells], at most 1

  /// The mean over points of a power of their weight to the row.
  [[nodiscard]] double mean_weight(int power) const {
    const Particles<D> particles = points();
    double sum = 0;
    for (Index p = 0; p < particles.size(); ++p) {
      sum += std::pow(particles.position.component(normal)[p] / Bar::spacing, power);
    }
    return sum / static_cast<double>(particles.size());
  }

  /// The sum from which on a wave grows of which its points see so much.  Eq. (M174)
  /// @param passed_on A by those that pass their gradient on
  [[nodiscard]] double critical_sum(double velocity, double passed_on, double gradient) const {
    const double share = std::visit([](const auto& rule) { return rule.increment_share(); }, transfer);
    const bool has_affine = std::visit([](const auto& rule) { return rule.has_affine; }, transfer);
    const double back = has_affine ? passed_on : 0;
    const double felt = order == Order::usl ? 1 + share - share * velocity : velocity + (1 + share) * back;
    return 2 / gradient * ((1 + share) * (1 + back) + (1 - share) * velocity) / felt;
  }

  [[nodiscard]] double grown(double sum, double viscous, int num_steps) const {
    constexpr double dt = 0.01;
    auto particles = points();
    auto stages = stages_of<D, D>(particles, Linear{}, transfer, fluid_of(sum, viscous, dt));
    stages.order = order;
    stages.boundaries.push_back(make_wall<D>(NoSlip{}, normal, Side::low));
    return growth<D>(std::move(particles), grid(), stages, dt, num_steps);
  }

  [[nodiscard]] std::string name() const {
    std::ostringstream text;
    text << std::visit([](const auto& rule) { return rule.name; }, transfer) << " "
         << order_names[static_cast<std::size_t>(order)] << ", " << thickness << " cells";
    return text.str();
  }

 private:
  static constexpr int normal = D - 1;

  [[nodiscard]] static CartesianGrid<D> grid() {
    Indices<D> count{};
    count.fill(Bar::num_cells);
    std::array<bool, static_cast<std::size_t>(D)> is_periodic{};
    is_periodic.fill(true);
    is_periodic[normal] = false;
    return {Vector<D>::Zero(), Vector<D>::Constant(Bar::spacing), count, is_periodic};
  }

  [[nodiscard]] Particles<D> points() const {
    Indices<D> per_cell{};
    per_cell.fill(1);
    per_cell[normal] = 8;
    Vector<D> high = Vector<D>::Constant(Bar::num_cells * Bar::spacing);
    high[normal] = thickness * Bar::spacing;
    return seed_box<D, D>(grid(), Vector<D>::Zero(), high, per_cell, 1000);
  }
};

/// All of the row moves as one along the normal: P = <w^2>/<w>, of points that pass on their gradient the
/// rest of 1 comes back by it, and Lambda = 1/<w> = 2/t, by which `apic` bears a sum of 2 t.
TEST(LayerOnWall, BeginsToGrowAlongTheNormalByTheMeanOfItsWeights) {  // Eq. (M174)
  constexpr int num_steps = 200;
  std::vector<AnyTransfer> transfers = every<AnyTransfer>();
  transfers.emplace_back(PicFlip{0.5});
  for (const AnyTransfer& transfer : transfers) {
    for (const Order order : {Order::usl, Order::musl, Order::usf}) {
      for (const double thickness : {1.0, 0.5, 0.25}) {
        const LayerOnWall<1> layer{transfer, order, thickness};
        const double mean = layer.mean_weight(1);
        const double seen = layer.mean_weight(2) / mean;
        const double sum = layer.critical_sum(seen, 1 - seen, 1 / mean);
        if (std::holds_alternative<Apic>(transfer)) {
          EXPECT_NEAR(sum, 2 * thickness, 100 * round_off);
        }
        for (const double viscous : {0.0, 0.5, 1.0}) {
          EXPECT_LE(layer.grown(0.97 * sum, viscous, num_steps), 2) << layer.name();
          EXPECT_GE(layer.grown(1.03 * sum, viscous, num_steps), std::pow(1.03, num_steps) / 10)
              << layer.name();
        }
      }
    }
  }
}

/// The shortest wave along the wall, of which points in the middle of cells see no velocity: Lambda and A are
/// <w^2>/<w> times 4 and 1. From three quarters of a cell on it grows before what moves along the normal.
TEST(LayerOnWall, BeginsToGrowAlongItByTheMeanOfSquaredWeights) {  // Eq. (M174)
  constexpr int num_steps = 200;
  for (const AnyTransfer& transfer : every<AnyTransfer>()) {
    for (const double thickness : {1.0, 0.875}) {
      const LayerOnWall<2> layer{transfer, Order::usl, thickness};
      const double share = layer.mean_weight(2) / layer.mean_weight(1);
      const double sum = layer.critical_sum(0, share, 4 * share);
      EXPECT_LE(layer.grown(0.97 * sum, 0, num_steps), 2) << layer.name();
      EXPECT_GE(layer.grown(1.03 * sum, 0, num_steps), std::pow(1.03, num_steps) / 10) << layer.name();
    }
  }
}

}  // namespace
}  // namespace scree::mpm
