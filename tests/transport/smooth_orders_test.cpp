// Orders on a sine. The errors themselves are compared with tables in sine_table_test.cpp and others.

#include "lines.hpp"

#include <scree/transport/integrators.hpp>
#include <scree/transport/laws/advection.hpp>
#include <scree/transport/reconstructions.hpp>
#include <scree/transport/solver.hpp>

#include <gtest/gtest.h>

namespace scree::transport {
namespace {

using test::Centred;
using test::pi;

struct Errors {
  double l1;
  double linf;
};

/// sin x, one period round [0, 2 pi], CFL 0.4.
template <class L>
Errors sine(Index n, const L& limiter, Stages stages) {
  const Lattice<1> lattice = test::line(n, 0, 2 * pi);
  const auto exact = test::averages(lattice, [](double x) { return -std::cos(x); });
  Solver solver{
      Cartesian<1>{lattice}, Advection<1>{Vector<1>{1.0}}, PiecewiseLinear{limiter}, stages, {.cfl = 0.4}};
  auto u = exact;

  solver.advance(u, 2 * pi);

  return {test::l1(u, exact, lattice.spacing[0]), test::linf(u, exact)};
}

TEST(Sine, HasTheOrdersOfTheory) {
  const auto order = [](double coarse, double fine) { return std::log2(coarse / fine); };
  const Errors centred_coarse = sine(320, Centred{}, SspRk2{});
  const Errors centred_fine = sine(640, Centred{}, SspRk2{});
  EXPECT_NEAR(order(centred_coarse.l1, centred_fine.l1), 2, 0.01);
  EXPECT_NEAR(order(centred_coarse.linf, centred_fine.linf), 2, 0.01);

  // Clipped extrema: about 4/3 in the largest error, 2 in the mean.
  const Errors limited_coarse = sine(320, VanLeer{}, SspRk2{});
  const Errors limited_fine = sine(640, VanLeer{}, SspRk2{});
  EXPECT_GE(order(limited_coarse.l1, limited_fine.l1), 1.85);
  EXPECT_GE(order(limited_coarse.linf, limited_fine.linf), 1.2);
  EXPECT_LE(order(limited_coarse.linf, limited_fine.linf), 1.45);
}

}  // namespace
}  // namespace scree::transport
