// Flows of a fluid that is stiffer where its grains are coarser, with exact solutions.

#include "points.hpp"

#include <scree/rheology/laws/size_dependent_newtonian.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace scree::rheology {
namespace {

constexpr SizeDependentNewtonian law{.viscosity_per_size = 1e6, .bulk_modulus = 1e7, .density = 1000};

/// Viscosity that the law has at a grain size [Pa s].
[[nodiscard]] double viscosity(double size) {
  return stress(law, simple_shear(1), law.density, size)(0, 1);
}

/// Plane-parallel flow: speeds at nodes, in between cells of one grain size each, by explicit steps.
struct Channel {
  double dx;                  // [m]
  double force;               // along the flow, per volume [N/m^3]
  std::vector<double> size;   // of each cell [m]
  std::vector<double> speed;  // of each node, one more [m/s]; the first and the last are left alone

  void step(double dt) {
    std::vector<double> tau(size.size());
    for (std::size_t c = 0; c < size.size(); ++c) {
      tau[c] = stress(law, simple_shear((speed[c + 1] - speed[c]) / dx), law.density, size[c])(0, 1);
    }
    for (std::size_t i = 1; i < size.size(); ++i) {
      speed[i] += dt / law.density * (force + (tau[i] - tau[i - 1]) / dx);
    }
  }
};

/// A channel driven by a force f with grains of one size in its lower part a and of another in its upper part
/// b. Nodes are exact in the steady state, as in any such scheme whose cells know one viscosity each.
TEST(SizeDependentNewtonian, MakesTheTwoParabolasOfTwoLayers) {  // Eq. (R34)
  constexpr int num_cells = 20;
  constexpr int num_fine = 8;
  constexpr double dx = 0.1 / num_cells;
  const double mu_1 = viscosity(0.25e-3);
  const double mu_2 = viscosity(1e-3);
  Channel channel{dx, 5000, std::vector<double>(num_cells, 1e-3), std::vector<double>(num_cells + 1)};
  std::fill_n(channel.size.begin(), num_fine, 0.25e-3);

  // Its slowest decay is not slower than that of fine grains alone, mu_1/rho (pi/H)^2; 30 of these times
  // leave 1e-13.
  const double dt = 0.4 * law.density * dx * dx / mu_2;
  const double time = 30 * law.density * std::pow(0.1 / std::numbers::pi, 2) / mu_1;
  for (int n = 0; n * dt < time; ++n) channel.step(dt);

  const double a = num_fine * dx;
  const double b = 0.1 - a;
  const double turn = (a * a / mu_1 + (0.1 * 0.1 - a * a) / mu_2) / (2 * (a / mu_1 + b / mu_2));  // tau = 0
  const auto exact = [&](double y) {
    if (y <= a) return 5000 / mu_1 * y * (turn - y / 2);
    return 5000 / mu_2 * (0.1 - y) * (0.1 - turn - (0.1 - y) / 2);
  };
  EXPECT_NEAR(exact(a), 5000 / mu_2 * b * (0.1 - turn - b / 2),
              1e-13 * exact(a));  // the layers move together
  for (int i = 0; i <= num_cells; ++i) {
    // Rounding of the stress, over and over, is multiplied by the condition of the system, (H/dx)^2.
    const double tolerance = (1e-13 + 10 * num_cells * num_cells * round_off) * exact(a);
    EXPECT_NEAR(channel.speed[static_cast<std::size_t>(i)], exact(i * dx), tolerance) << i;
  }
}

/// A plate that swings at omega: grains follow over a depth of sqrt(2 M s_a/(rho omega)) in each e-fold,
/// twice as far if they are four times as large.
[[nodiscard]] double error_above_a_plate(double size, double depth, int cells_per_depth) {
  constexpr double omega = 2 * std::numbers::pi;  // a period of 1 s
  const auto exact = [&](double y, double t) {
    return std::exp(-y / depth) * std::cos(omega * t - y / depth);
  };
  const int num_cells = 6 * cells_per_depth;
  const double dx = depth / cells_per_depth;
  Channel channel{dx, 0, std::vector<double>(static_cast<std::size_t>(num_cells), size), {}};
  for (int i = 0; i <= num_cells; ++i) channel.speed.push_back(exact(i * dx, 0));

  // 0.25 rho dx^2/mu, with mu of the depth
  const int num_steps = static_cast<int>(std::ceil(4 * std::numbers::pi * std::pow(cells_per_depth, 2)));
  double error = 0;
  for (int n = 1; n <= num_steps; ++n) {
    channel.step(1.0 / num_steps);
    const double t = static_cast<double>(n) / num_steps;
    channel.speed.front() = exact(0, t);
    channel.speed.back() = exact(num_cells * dx, t);
  }
  for (int i = 0; i <= num_cells; ++i) {
    error = std::max(error, std::abs(channel.speed[static_cast<std::size_t>(i)] - exact(i * dx, 1)));
  }
  return error;
}

TEST(SizeDependentNewtonian, SwingsWithAPlateOverADepthOfTheRootOfItsSize) {  // Eq. (R35), Stokes (1851)
  for (const double size : {0.25e-3, 1e-3}) {
    const double depth = std::sqrt(2 * 1e6 * size / (1000 * 2 * std::numbers::pi));  // [m]
    const double coarse = error_above_a_plate(size, depth, 5);
    const double fine = error_above_a_plate(size, depth, 10);

    // A step leaves (dt/2 - dx^2/(12 nu)) u_tt = dx^2/(24 nu) u_tt, at most omega/12 (dx/depth)^2, and errors
    // do not grow beyond what is added to them: over the period pi/6 (dx/depth)^2. The next term is of fourth
    // order, 1/25 of it.
    EXPECT_LE(fine, std::numbers::pi / 6 / 100);
    EXPECT_NEAR(std::log2(coarse / fine), 2, 0.1);
  }
}

/// Where it fails: in a cell that layers of two sizes share, the arithmetic mean is too stiff, by s_a/s_h,
/// for layers give way one by one. The error is of first order; a cell that is given s_h has none.
TEST(SizeDependentNewtonian, IsTooStiffWhereACellHoldsTwoLayers) {  // Eq. (R4)
  const double fine = 0.25e-3;
  const double coarse = 1e-3;
  const double tau = 100;                     // [Pa]
  for (const int num_cells : {5, 11, 101}) {  // the middle one is half and half
    const double dx = 1.0 / num_cells;
    const auto top_speed = [&](double in_the_middle) {
      double sum = 0;
      for (int c = 0; c < num_cells; ++c) {
        const double size = c < num_cells / 2 ? fine : c > num_cells / 2 ? coarse : in_the_middle;
        sum += dx * tau / viscosity(size);
      }
      return sum;
    };
    const double exact = tau * (0.5 / viscosity(fine) + 0.5 / viscosity(coarse));
    const double arithmetic = (fine + coarse) / 2;
    const double harmonic = 2 / (1 / fine + 1 / coarse);
    const double lost = dx * tau / 1e6 * (1 / harmonic - 1 / arithmetic);

    const double tolerance = 10 * num_cells * round_off * exact;  // a sum of positive terms
    EXPECT_NEAR(top_speed(arithmetic), exact - lost, tolerance);
    EXPECT_NEAR(top_speed(harmonic), exact, tolerance);
  }
}

}  // namespace
}  // namespace scree::rheology
