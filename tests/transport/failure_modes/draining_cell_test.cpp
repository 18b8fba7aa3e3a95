// Failure mode 12: several faces drain one cell. A limit for each face by itself lets them take out more than
// there is.

#include "../lines.hpp"

#include <scree/transport/integrators.hpp>
#include <scree/transport/laws/advection.hpp>
#include <scree/transport/limiters.hpp>
#include <scree/transport/reconstructions.hpp>
#include <scree/transport/solver.hpp>

#include <gtest/gtest.h>

#include <numeric>

namespace scree::transport {
namespace {

constexpr Index n = 5;
constexpr Index centre = 12;  // (2, 2)

/// Flow of speed one out of the cell in the middle through all its faces; still elsewhere.
struct Spring {
  Advection<2> at(const Face& face) const noexcept {
    Vector<2> velocity = Vector<2>::Zero();
    if (face.owner == centre) velocity[face.axis] = 1;
    if (face.neighbour == centre) velocity[face.axis] = -1;
    return {velocity};
  }
};

Lattice<2> plane() {
  Lattice<2> lattice = test::cube<2>(n);
  lattice.spacing = Vector<2>::Ones();
  return lattice;
}

/// One step of forward Euler, which no one checks.
std::vector<double> step(double dt) {
  using Rates = SemiDiscrete<Cartesian<2>, Spring, PiecewiseConstant, KurganovTadmor>;
  Rates rates{{plane(), Spring{}, PiecewiseConstant{}, {}, {}}, 0.5, {}};
  Fields<1> now{n * n};
  Fields<1> rate{n * n};
  now.data()[centre] = 1;
  rates(now, rate, 0);
  std::vector<double> u;
  for (Index site = 0; site < n * n; ++site) u.push_back(now.data()[site] + dt * rate.data()[site]);
  return u;
}

TEST(DrainingCell, GoesNegativeWithALimitPerFace) {  // dt a/dx <= 1 at each face: 1 - 4 is left
  EXPECT_DOUBLE_EQ(step(1)[centre], -3);
  EXPECT_DOUBLE_EQ(step(0.5)[centre], -1);  // a limit per axis is not enough either: each has two such faces
}

template <class R>
void expect_positive(const R& reconstruction) {
  std::vector<double> u(n * n, 0.0);
  u[centre] = 1;
  const double cfl = Solver<Cartesian<2>, Spring, R>::promised_cfl(reconstruction);
  Solver solver{Cartesian<2>{plane()}, Spring{}, reconstruction, ForwardEuler{}, {.cfl = cfl}};
  for (int i = 0; i < 20; ++i) {
    solver.advance(u, solver.stable_time_step(u));
    for (const double value : u) EXPECT_GE(value, -4 * round_off);  // four fluxes out of one
    EXPECT_NEAR(std::accumulate(u.begin(), u.end(), 0.0), 1,
                20 * 25 * round_off);  // a rounding a cell and step
  }
}

TEST(DrainingCell,
     KeepsItsSignByTheSumOfAllFaces) {  // Eq. (T9): at 1/2 the four take out all there is, no more
  EXPECT_NEAR(step(0.25)[centre], 0, 4 * round_off);
  expect_positive(PiecewiseConstant{});
  expect_positive(PiecewiseLinear{Minmod{1}});
  expect_positive(PiecewiseLinear{Minmod{2}});
}

}  // namespace
}  // namespace scree::transport
