// Smooth problems in two dimensions against tables of another code: 3 %, as in sine_table_test.cpp.

#include "planes.hpp"
#include "schemes.hpp"
#include "table.hpp"

#include <scree/transport/laws/advection.hpp>
#include <scree/transport/laws/burgers.hpp>

#include <gtest/gtest.h>

namespace scree::transport {
namespace {

using test::pi;
using test::Row;

class SinePlaneTable : public ::testing::TestWithParam<Row> {};
TEST_P(SinePlaneTable, IsReproduced) {
  const Row& row = GetParam();
  const Lattice<2> lattice = test::square(row.cells(), 0, 0, 2 * pi);
  const auto exact = test::sine_averages(lattice);
  auto u = exact;
  test::with_reconstruction(row.text("scheme"), [&](const auto& reconstruction) {
    Solver{Cartesian<2>{lattice},
           Advection<2>{Vector<2>{1, 1}},
           test::Unchecked{reconstruction},
           SspRk2{},
           {.cfl = 0.8}}
        .advance(u, 2 * pi);
  });
  EXPECT_NEAR(test::l1(u, exact, lattice.spacing.prod()), row.number("l1"), 0.03 * row.number("l1"));
  EXPECT_NEAR(test::linf(u, exact), row.number("linf"), 0.03 * row.number("linf"));
}
INSTANTIATE_TEST_SUITE_P(, SinePlaneTable, ::testing::ValuesIn(test::table("sine_2d.csv")), test::name_of);

class BurgersPlaneTable : public ::testing::TestWithParam<Row> {};
TEST_P(BurgersPlaneTable, IsReproduced) {
  const Row& row = GetParam();
  const Lattice<2> lattice = test::square(row.cells(), -2, -2, 4);
  auto u = test::burgers_averages(lattice, 0);
  test::with_reconstruction(row.text("scheme"), [&](const auto& reconstruction) {
    Solver solver{Cartesian<2>{lattice}, Burgers{}, test::Unchecked{reconstruction}, SspRk2{}, {.cfl = 0.8}};
    solver.advance(u, 0.5 / pi);
  });
  const auto exact = test::burgers_averages(lattice, 0.5 / pi);
  EXPECT_NEAR(test::l1(u, exact, lattice.spacing.prod()), row.number("l1"), 0.03 * row.number("l1"));
}
INSTANTIATE_TEST_SUITE_P(, BurgersPlaneTable, ::testing::ValuesIn(test::table("burgers_2d.csv")),
                         test::name_of);

}  // namespace
}  // namespace scree::transport
