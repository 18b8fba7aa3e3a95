// Gauss, square, triangle and ellipse carried round [-1, 1], against a table of another code: 3 % of l1, as
// in sine_table_test.cpp, and the bounds that a limiter must keep.

#include "schemes.hpp"
#include "table.hpp"

#include <scree/transport/laws/advection.hpp>

#include <gtest/gtest.h>

namespace scree::transport {
namespace {

using test::Row;

double gauss(double x, double centre) {
  constexpr double width = 0.005;
  const double sharpness = std::log(2.0) / (36 * width * width);
  return std::exp(-sharpness * (x - centre) * (x - centre));
}

double ellipse(double x, double centre) {
  return std::sqrt(std::max(1 - 100 * (x - centre) * (x - centre), 0.0));
}

/// The profile of Jiang & Shu (1996).
double profile(double x) {
  constexpr double shift = 0.005;
  const auto mean = [&](auto&& shape, double centre) {
    return (shape(x, centre - shift) + shape(x, centre + shift) + 4 * shape(x, centre)) / 6;
  };
  if (-0.8 <= x && x <= -0.6) return mean(gauss, -0.7);
  if (-0.4 <= x && x <= -0.2) return 1;
  if (0 <= x && x <= 0.2) return 1 - std::abs(10 * (x - 0.1));
  if (0.4 <= x && x <= 0.6) return mean(ellipse, 0.5);
  return 0;
}

std::vector<double> profile_averages(const Lattice<1>& lattice) {
  constexpr int num_points = 200;
  std::vector<double> u;
  for (Index i = 0; i < lattice.count[0]; ++i) {
    double sum = 0;
    for (int point = 0; point < num_points; ++point) {
      sum += profile(lattice.position({i})[0] + ((point + 0.5) / num_points - 0.5) * lattice.spacing[0]);
    }
    u.push_back(sum / num_points);
  }
  return u;
}

std::vector<double> carried(const Row& row) {
  const Lattice<1> lattice = test::line(row.cells(), -1, 1);
  auto u = profile_averages(lattice);
  test::with_reconstruction(row.text("scheme"), [&](const auto& reconstruction) {
    Solver{Cartesian<1>{lattice},
           Advection<1>{Vector<1>{1.0}},
           reconstruction,
           test::stages(row.text("time")),
           {.cfl = 0.4}}
        .advance(u, row.number("until"));
  });
  return u;
}

class ProfileTable : public ::testing::TestWithParam<Row> {};
TEST_P(ProfileTable, IsReproduced) {
  const Row& row = GetParam();
  const Lattice<1> lattice = test::line(row.cells(), -1, 1);

  const auto u = carried(row);

  const double l1 = test::l1(u, profile_averages(lattice), lattice.spacing[0]);
  const double highest = *std::max_element(u.begin(), u.end());
  const double lowest = *std::min_element(u.begin(), u.end());
  EXPECT_NEAR(l1, row.number("l1"), 0.03 * row.number("l1"));
  EXPECT_NEAR(highest, row.number("highest"), 0.03);
  EXPECT_NEAR(test::total_variation(u), row.number("variation"), 0.03 * row.number("variation"));
  if (row.text("scheme") == "centred") {
    EXPECT_LE(lowest, -0.15);  // Gibbs: nothing holds it
  } else if (row.text("scheme") == Cweno3::name) {
    EXPECT_NEAR(lowest, row.number("lowest"), 0.03 * std::abs(row.number("lowest")));
  } else {  // thousands of steps, each of some ten roundings of values of at most 1
    EXPECT_GE(lowest, -1e-12);
    EXPECT_LE(highest, 1 + 1e-12);
  }
}
std::vector<Row> stable_rows() {
  auto rows = test::table("profile.csv");
  std::erase_if(rows, [](const Row& row) {
    return row.text("time") == ForwardEuler::name &&
           (row.text("scheme") == "centred" || row.text("scheme") == Cweno3::name);
  });
  return rows;
}
INSTANTIATE_TEST_SUITE_P(, ProfileTable, ::testing::ValuesIn(stable_rows()), test::name_of);

}  // namespace
}  // namespace scree::transport
