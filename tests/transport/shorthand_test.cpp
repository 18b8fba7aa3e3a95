// What a user may leave out means what it says.

#include "lines.hpp"

#include <scree/box.hpp>
#include <scree/transport/laws/euler.hpp>
#include <scree/transport/limiters.hpp>
#include <scree/transport/reconstructions/piecewise_linear.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace scree::transport {
namespace {

TEST(Everywhere, IsOneBoundaryAtAllSides) {
  const BoxBoundaries<3, 5> sides = everywhere(Outflow{});
  for (const auto& axis : sides) {
    for (const auto& side : axis) EXPECT_TRUE(std::holds_alternative<Outflow>(side));
  }
}

TEST(Solver, TakesOptionsWithoutAnIntegrator) {  // the usual one: the same bits
  const Lattice<1> cells = box<1>({0}, {1}, {20}).cells();
  const Euler<1> gas;
  std::vector<double> start;
  for (Index i = 0; i < 20; ++i) {
    const auto cell = gas.state(i < 10 ? 1 : 0.125, Vector<1>{0.0}, i < 10 ? 1 : 0.1);
    start.insert(start.end(), cell.begin(), cell.end());
  }
  auto named = start;
  auto left_out = start;

  Solver{Cartesian{cells}, gas, PiecewiseLinear{Minmod{}}, SspRk2{}, {.boundaries = everywhere(Outflow{})}}
      .advance(named, 0.1);
  Solver{Cartesian{cells}, gas, PiecewiseLinear{Minmod{}}, {.boundaries = everywhere(Outflow{})}}.advance(
      left_out, 0.1);

  EXPECT_EQ(named, left_out);
  EXPECT_NE(named, start);
}

}  // namespace
}  // namespace scree::transport
