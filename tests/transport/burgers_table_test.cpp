// Burgers' equation from 0.5 + sin x before and after its shock, against a table of another code: 3 %, as in
// sine_table_test.cpp. After the shock the error is that of where it sits in its cell: no orders there.

#include "schemes.hpp"
#include "table.hpp"

#include <scree/transport/laws/burgers.hpp>

#include <gtest/gtest.h>

namespace scree::transport {
namespace {

using test::pi;
using test::Row;

/// Potential of the exact solution (Hopf and Lax): its differences are averages, whatever the time.
///
/// The minimum over the foot y of U(y) + (x - y)^2/(2 t), with U an antiderivative of the start.
double potential(double x, double time) {
  const auto start = [](double y) { return 0.5 * y - std::cos(y); };
  if (time == 0) return start(x);
  const auto value = [&](double y) { return start(y) + (x - y) * (x - y) / (2 * time); };
  double smallest = std::numeric_limits<double>::infinity();
  constexpr int num_starts = 64;  // of Newton's method, over all feet: x - 1.5 t .. x + 0.5 t
  for (int i = 0; i <= num_starts; ++i) {
    double y = x - time * (1.5 - 2.0 * i / num_starts);
    smallest = std::min(smallest, value(y));
    for (int step = 0; step < 30; ++step) {
      const double curvature = std::cos(y) + 1 / time;
      if (curvature <= 0) break;  // a maximum, not a minimum
      y -= (0.5 + std::sin(y) + (y - x) / time) / curvature;
    }
    smallest = std::min(smallest, value(y));
  }
  return smallest;
}

struct Errors {
  double l1;
  double linf;
};

Errors burgers(const Row& row, Index n) {
  const Lattice<1> lattice = test::line(n, 0, 2 * pi);
  const double until = row.number("until");
  auto u = test::averages(lattice, [](double x) { return potential(x, 0); });
  test::with_reconstruction(row.text("scheme"), [&](const auto& reconstruction) {
    const Stages stages = test::stages(row.text("time"));
    Solver solver{Cartesian<1>{lattice}, Burgers{}, reconstruction, stages, {.cfl = 0.4}};
    test::advance_in_full_steps(solver, u, until);
  });
  const auto exact = test::averages(lattice, [&](double x) { return potential(x, until); });
  return {test::l1(u, exact, lattice.spacing[0]), test::linf(u, exact)};
}

class BurgersTable : public ::testing::TestWithParam<Row> {};
TEST_P(BurgersTable, IsReproduced) {
  const Row& row = GetParam();
  const Errors errors = burgers(row, row.cells());
  EXPECT_NEAR(errors.l1, row.number("l1"), 0.03 * row.number("l1"));
  EXPECT_NEAR(errors.linf, row.number("linf"), 0.03 * row.number("linf"));
}
INSTANTIATE_TEST_SUITE_P(, BurgersTable, ::testing::ValuesIn(test::table("burgers.csv")), test::name_of);

class BurgersOrders : public ::testing::TestWithParam<Row> {};
TEST_P(BurgersOrders, AreThoseOfTheoryBeforeTheShock) {
  const Row& row = GetParam();
  const double order = std::log2(burgers(row, 320).l1 / burgers(row, 640).l1);
  if (row.text("scheme") == Cweno3::name) {
    EXPECT_GE(order, 3);
  } else {
    EXPECT_GE(order, row.text("scheme") == "centred" ? 1.95 : 1.85);
  }
}
std::vector<Row> smooth_rows() {
  return test::rows_with(test::rows_with(test::table("burgers.csv"), "cells", "640"), "until", "0.5");
}
INSTANTIATE_TEST_SUITE_P(, BurgersOrders, ::testing::ValuesIn(smooth_rows()), test::name_of);

/// After the shock: the error falls over many grids, whatever two neighbouring ones say.
TEST(BurgersShock, ConvergesAtFirstOrderOverManyGrids) {
  for (const char* scheme : {"minmod 1", "minmod 2", "van_leer"}) {
    const Row row{{"scheme", "time", "until"}, {scheme, "ssp_rk2", "2"}};
    double sum_xy = 0;
    double sum_xx = 0;
    const std::array<Index, 6> grids{40, 80, 160, 320, 640, 1280};  // log2: their mean is at 2.5 steps
    for (std::size_t i = 0; i < grids.size(); ++i) {
      const double x = static_cast<double>(i) - 2.5;
      sum_xy += x * std::log2(burgers(row, grids[i]).l1);
      sum_xx += x * x;
    }
    EXPECT_GE(-sum_xy / sum_xx, 0.75) << scheme;
  }
}

}  // namespace
}  // namespace scree::transport
