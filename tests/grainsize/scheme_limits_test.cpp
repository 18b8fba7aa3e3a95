// Where the scheme's choices bind: each test takes one of them away and shows what breaks.

#include "column.hpp"

#include <scree/grainsize/segregation_law.hpp>
#include <scree/transport/reconstructions/piecewise_linear.hpp>
#include <scree/transport/reconstructions/piecewise_linear_common.hpp>
#include <scree/transport/solver.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace scree::grainsize {
namespace {

using test::Column;
using transport::Minmod;

constexpr Index num_cells = 100;
constexpr std::array<double, 3> three_sizes{1 / 0.5, 1 / 0.75, 1 / 1.0};
constexpr std::array<double, 2> two_sizes{1 / 0.5, 1 / 1.0};

/// Segregation of N sizes under a driver of 1 m/s.
template <int N>
PointSegregation<N> unit_law(const std::array<double, N>& inverse_sizes) {
  return {&inverse_sizes, 1, 0};
}

std::vector<double> equal_shares(std::size_t num_classes) {
  return std::vector<double>(static_cast<std::size_t>(num_cells) * num_classes,
                             1 / static_cast<double>(num_classes));
}

double sum_error(const std::vector<double>& fractions, std::size_t num_classes) {
  double largest = 0;
  for (std::size_t i = 0; i < fractions.size(); i += num_classes) {
    double sum = 0;
    for (std::size_t k = 0; k < num_classes; ++k) sum += fractions[i + k];
    largest = std::max(largest, std::abs(sum - 1));
  }
  return largest;
}

TEST(OneLimiterForAllClasses, KeepsTheSumThatSeparateOnesLose) {
  const auto run = [](const auto& reconstruction) {
    transport::Solver solver{transport::Cartesian<1>{Column::lattice(num_cells)},
                             unit_law<3>(three_sizes),
                             reconstruction,
                             transport::SspRk2{},
                             {.cfl = 0.5}};
    std::vector<double> fractions = equal_shares(3);
    solver.advance(fractions, 0.7);
    return sum_error(fractions, 3);
  };

  EXPECT_LE(run(transport::PiecewiseLinearCommon{Minmod{1.3}}), 1e-14);
  EXPECT_GE(run(transport::PiecewiseLinear{Minmod{1.3}}), 1e-3);
}

/// Two sizes with the velocity of the fines for a wave speed: zero in pure fines, where the wave that brings
/// them runs at B q/r, so that the flux there is the undamped central one.
struct WithTheClassesOwnSpeed : PointSegregation<2> {
  template <int D>
  [[nodiscard]] double max_speed(const State& left, const State& right,
                                 const Vector<D>& /*normal*/) const noexcept {
    const auto velocity = [&](const State& phi) {
      const double s_h = (phi[0] + phi[1]) / (phi[0] * (*inverse_sizes)[0] + phi[1] * (*inverse_sizes)[1]);
      return driver * (s_h * (*inverse_sizes)[0] - 1);
    };
    return transport::larger(velocity(left), velocity(right));
  }
};

TEST(OneSpeedForAllClasses, KeepsBoundsThatTheClassesOwnSpeedBreaks) {
  const auto highest = [](const auto& law) {
    transport::Solver solver{transport::Cartesian<1>{Column::lattice(num_cells)},
                             law,
                             transport::PiecewiseLinearCommon{Minmod{1.3}},
                             transport::SspRk2{},
                             {.cfl = 0.5}};
    std::vector<double> fractions = equal_shares(2);
    solver.advance(fractions, 0.7);
    return *std::max_element(fractions.begin(), fractions.end());
  };

  EXPECT_LE(highest(unit_law<2>(two_sizes)), 1 + 1e-14);
  EXPECT_GE(highest(WithTheClassesOwnSpeed{unit_law<2>(two_sizes)}), 1 + 1e-3);
}

TEST(BalanceByMass, KeepsClassMassThatTheUnweightedBalanceLoses) {  // Eq. (M1) against the paper's eq. (7)
  Column column{SizeClasses{{0.5, 1}}, num_cells};
  column.set([](double z, std::size_t) { return z / 2; });
  for (std::size_t i = 0; i < column.size(); ++i) {  // full below, a surface layer that thins out above
    column.masses()[i] *= std::clamp(2 - 2 * column.bottom(i), 0.02, 1.0);
  }
  const double before = column.class_mass(0);
  transport::Solver unweighted{transport::Cartesian<1>{Column::lattice(num_cells)},
                               unit_law<2>(two_sizes),
                               transport::PiecewiseLinearCommon{Minmod{1.3}},
                               transport::SspRk2{},
                               {.cfl = 0.5}};
  std::vector<double> fractions = column.fractions();

  const auto report = column.advance(0.5);
  unweighted.advance(fractions, 0.5);

  double unweighted_mass = 0;
  for (std::size_t i = 0; i < column.size(); ++i) unweighted_mass += column.masses()[i] * fractions[2 * i];
  // Two stages a substep, each rounding the fractions by a few round-offs.
  EXPECT_NEAR(column.class_mass(0) / before, 1, 8 * report.substeps * round_off);
  // Fines sink at f = 1/6 m/s through the upper half, where m/V falls by 2 per metre, but for the pure coarse
  // layer that grows from the top at 1/3 m/s: gain = int_0^t 2/6 (1/2 - t/3) dt = t/6 - t^2/18 of all 3/8 kg.
  const double predicted = (0.5 / 6 - 0.25 / 18) / 0.375;
  EXPECT_NEAR(unweighted_mass / before - 1, predicted, 2.0 / num_cells);  // two cells of smeared shock
}

}  // namespace
}  // namespace scree::grainsize
