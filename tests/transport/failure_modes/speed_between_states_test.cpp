// Failure mode 9 on a line: fluxes that are not convex are faster between two states than at either. Errors
// against tables of another code, 3 %.

#include "../schemes.hpp"
#include "../table.hpp"

#include <scree/transport/laws/buckley_leverett.hpp>

#include <gtest/gtest.h>

namespace scree::transport {
namespace {

using test::Row;

/// f = 16 u^2 (1 - u)^2: no speed at 0 nor at 1, but between.
struct Hump {
  static constexpr int num_components = 1;
  using State = std::array<double, 1>;
  bool looks_between;

  static double slope(double u) { return 32 * u * (1 - u) * (1 - 2 * u); }
  static double largest_slope() { return slope(0.5 - 0.5 / std::sqrt(3.0)); }  // 3.0792

  State flux(const State& u, const Vector<1>& normal) const noexcept {
    return {normal[0] * std::pow(4 * u[0] * (1 - u[0]), 2)};
  }
  double max_speed(const State& left, const State& right, const Vector<1>& /*normal*/) const noexcept {
    double speed = std::max(std::abs(slope(left[0])), std::abs(slope(right[0])));
    if (!looks_between) return speed;
    for (const double steepest : {0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)}) {
      if ((left[0] - steepest) * (right[0] - steepest) < 0)
        speed = std::max(speed, std::abs(slope(steepest)));
    }
    return speed;
  }
};

/// Averages of the exact solution from 1 | 0 at x = 0: u(x/t) = argmax_w f(w) - w x/t, by its potential.
template <class Law>
std::vector<double> exact(const Lattice<1>& lattice, const Law& law, double time) {
  constexpr int num_samples = 20000;
  std::vector<double> flux;
  const Vector<1> normal{1.0};
  for (int i = 0; i <= num_samples; ++i) flux.push_back(law.flux({i / double{num_samples}}, normal)[0]);
  return test::averages(lattice, [&](double x) {
    double largest = -std::numeric_limits<double>::infinity();
    for (int i = 0; i <= num_samples; ++i) {
      largest = std::max(largest, flux[static_cast<std::size_t>(i)] - i / double{num_samples} * x / time);
    }
    return -time * largest;
  });
}

std::vector<double> step_down(const Lattice<1>& lattice) {
  std::vector<double> u;
  for (Index i = 0; i < lattice.count[0]; ++i) u.push_back(lattice.position({i})[0] < 0 ? 1 : 0);
  return u;
}

template <class Law, class R>
auto open_solver(const Lattice<1>& lattice, const Law& law, const R& reconstruction) {
  return Solver{Cartesian<1>{lattice},
                law,
                reconstruction,
                SspRk2{},
                {.cfl = 0.4, .boundaries = {{{Outflow{}, Outflow{}}}}}};
}

/// l1 of the step 1 | 0 on [-2, 2] at T = 0.5, with the step of the table: 0.4 dx over the largest |f'|.
template <class R>
double error(Index n, const Hump& law, const R& reconstruction) {
  const Lattice<1> lattice = test::line(n, -2, 2, false);
  const double dx = lattice.spacing[0];
  auto u = step_down(lattice);
  test::advance_in_steps_of(0.4 * dx / Hump::largest_slope(), open_solver(lattice, law, reconstruction), u,
                            0.5);
  return test::l1(u, exact(lattice, law, 0.5), dx);
}

TEST(SpeedBetweenTwoStates, IsMissedAtTheEnds) {  // the jump is frozen: error 1 on every grid
  for (const Index n : {100, 200}) {
    EXPECT_NEAR(error(n, Hump{false}, PiecewiseLinear{Minmod{2}}), 1.0, 1e-6);  // sampling of w
  }
}

class QuarticTable : public ::testing::TestWithParam<Row> {};
TEST_P(QuarticTable, IsReproducedWithTheSpeedBetween) {
  const Row& row = GetParam();
  const double l1 = test::with_reconstruction(row.text("scheme"), [&](const auto& reconstruction) {
    return error(row.cells(), Hump{true}, reconstruction);
  });
  EXPECT_NEAR(l1, row.number("l1"), 0.03 * row.number("l1"));
}
INSTANTIATE_TEST_SUITE_P(, QuarticTable, ::testing::ValuesIn(test::table("quartic.csv")), test::name_of);

class BuckleyLeverettTable : public ::testing::TestWithParam<Row> {};
TEST_P(BuckleyLeverettTable, IsReproduced) {
  const Row& row = GetParam();
  const Lattice<1> lattice = test::line(row.cells(), -1, 2, false);
  auto u = step_down(lattice);
  test::with_reconstruction(row.text("scheme"), [&](const auto& reconstruction) {
    test::advance_in_full_steps(open_solver(lattice, BuckleyLeverett{}, reconstruction), u, 1);
  });
  const double l1 = test::l1(u, exact(lattice, BuckleyLeverett{}, 1), lattice.spacing[0]);
  EXPECT_NEAR(l1, row.number("l1"), 0.03 * row.number("l1"));
}
INSTANTIATE_TEST_SUITE_P(, BuckleyLeverettTable, ::testing::ValuesIn(test::table("buckley_leverett.csv")),
                         test::name_of);

}  // namespace
}  // namespace scree::transport
