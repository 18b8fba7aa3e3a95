// Failure mode 5: a flux that is upwind by the speed of the jump takes a fan with a sonic point for a shock.

#include "../lines.hpp"

#include <scree/transport/integrators.hpp>
#include <scree/transport/laws/burgers.hpp>
#include <scree/transport/limiters.hpp>
#include <scree/transport/reconstructions.hpp>
#include <scree/transport/solver.hpp>

#include <gtest/gtest.h>

namespace scree::transport {
namespace {

/// Roe's flux without an entropy fix: all from one side, by the speed of the jump between both.
struct Roe {
  static constexpr std::string_view name = "roe";
  static constexpr std::string_view summary = "upwind by the speed of the jump";

  template <class Law, int D>
  FaceFlux<typename Law::State> operator()(const Law& law, const typename Law::State& left,
                                           const typename Law::State& right,
                                           const Vector<D>& normal) const noexcept {
    const double speed = (left[0] + right[0]) / 2;  // (f(right) - f(left))/(right - left) of u^2/2
    const double mean = 0.5 * (law.flux(left, normal)[0] + law.flux(right, normal)[0]);
    return {{mean - 0.5 * std::abs(speed) * (right[0] - left[0])}, law.max_speed(left, right, normal)};
  }
};

constexpr Index n = 100;

/// -1 | 1 at x = 0 on [-2, 2] until T = 1.
template <class R, class Flux>
std::vector<double> fan(Index num_cells, const R& reconstruction, const Flux& flux) {
  std::vector<double> u(static_cast<std::size_t>(num_cells), 1.0);
  std::fill(u.begin(), u.begin() + num_cells / 2, -1.0);
  Solver solver{Cartesian<1>{test::line(num_cells, -2, 2, false)},      Burgers{}, reconstruction, SspRk2{},
                {.cfl = 0.4, .boundaries = {{{Outflow{}, Outflow{}}}}}, flux};
  solver.advance(u, 1);
  return u;
}

double l1(const std::vector<double>& u) {  // exact: x, from -1 to 1
  const Lattice<1> lattice = test::line(static_cast<Index>(u.size()), -2, 2);
  const auto exact =
      test::averages(lattice, [](double x) { return std::abs(x) < 1 ? x * x / 2 : std::abs(x) - 0.5; });
  return test::l1(u, exact, lattice.spacing[0]);
}

/// Slope at the sonic point; exact 1.
double slope(const std::vector<double>& u) {
  return (u[n / 2] - u[n / 2 - 1]) / (4.0 / n);
}

TEST(SonicPoint, IsFrozenByAFluxWithoutAnEntropyFix) {  // the jump stands: an error of 1 on every grid
  for (const Index num_cells : {50, 100, 200}) {
    EXPECT_NEAR(l1(fan(num_cells, PiecewiseConstant{}, Roe{})), 1, 1e-12) << num_cells;
    EXPECT_NEAR(l1(fan(num_cells, PiecewiseLinear{Minmod{2}}, Roe{})), 1, 1e-12) << num_cells;
  }
}

TEST(SonicPoint, OpensWithTheCentralFlux) {  // table of another code: 2.44, 1.22, 1.013
  EXPECT_NEAR(slope(fan(n, PiecewiseConstant{}, KurganovTadmor{})), 2.44, 0.03 * 2.44);
  EXPECT_NEAR(slope(fan(n, PiecewiseLinear{Minmod{1}}, KurganovTadmor{})), 1.22, 0.03 * 1.22);
  EXPECT_NEAR(slope(fan(n, PiecewiseLinear{Minmod{2}}, KurganovTadmor{})), 1.013, 0.03 * 1.013);
}

}  // namespace
}  // namespace scree::transport
