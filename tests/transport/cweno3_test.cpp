#include "lines.hpp"

#include <scree/transport/integrators.hpp>
#include <scree/transport/laws/advection.hpp>
#include <scree/transport/laws/burgers.hpp>
#include <scree/transport/reconstructions/cweno3.hpp>
#include <scree/transport/solver.hpp>

#include <gtest/gtest.h>

#include <complex>
#include <limits>
#include <random>

namespace scree::transport {
namespace {

using State = std::array<double, 1>;

TEST(Cweno3, KeepsLinearProfiles) {  // Eq. (T40): all three candidates are the line
  const auto edges = Cweno3{}(State{1}, State{3}, State{5});
  EXPECT_NEAR(edges.low[0], 2, 8 * 5 * round_off);  // eight operations on values of at most 5
  EXPECT_NEAR(edges.high[0], 4, 8 * 5 * round_off);
}

/// Error at a face from averages of cos x over cells of width h.
double face_error(double h) {
  const auto mean = [&](double x) { return (std::sin(x + h / 2) - std::sin(x - h / 2)) / h; };  // of cos
  const auto edges = Cweno3{1e3}(State{mean(0.7 - h)}, State{mean(0.7)}, State{mean(0.7 + h)});
  return std::abs(edges.high[0] - std::cos(0.7 + h / 2));
}

TEST(Cweno3, IsThirdOrderAtTheFacesOnceDifferencesAreSmall) {  // far below a thousandth of the scale
  EXPECT_NEAR(std::log2(face_error(0.02) / face_error(0.01)), 3, 0.05);  // the next term is as 1 to 0.01
}

TEST(Cweno3, TakesTheSideThatDoesNotCrossAJump) {
  const auto edges = Cweno3{}(State{0}, State{0.01}, State{1});
  EXPECT_NEAR(edges.low[0], 0.005, 1e-5);  // the line from below; the others' share is (0.01/1)^4 and less
  EXPECT_NEAR(edges.high[0], 0.015, 1e-5);
}

TEST(Cweno3, DoesNotDependOnTheUnitOfItsScale) {  // eight operations on values of at most 0.8, times 1e6
  const auto small = Cweno3{}(State{0.2}, State{0.3}, State{0.8});
  const auto large = Cweno3{1e6}(State{0.2e6}, State{0.3e6}, State{0.8e6});
  EXPECT_NEAR(large.low[0], 1e6 * small.low[0], 1e6 * 8 * round_off);
  EXPECT_NEAR(large.high[0], 1e6 * small.high[0], 1e6 * 8 * round_off);
}

/// Largest |amplification| of one step of SspRk3 at a CFL number, with the same weights in all cells, of any
/// wave. Advection to the right: du/dt = -(high_i - high_(i-1))/dx.
double amplification(double cfl, double below, double above) {
  using Complex = std::complex<double>;
  double largest = 0;
  constexpr int num_waves = 400;
  for (int wave = 0; wave <= num_waves; ++wave) {
    const Complex shift = std::polar(1.0, test::pi * wave / num_waves);
    const Complex backward = 1.0 - 1.0 / shift;
    const Complex forward = shift - 1.0;
    const double here = 1 - below - above;
    const Complex high = 1.0 +
                         0.5 * (below * backward + above * forward + 0.5 * here * (backward + forward)) +
                         here * (forward - backward) / 6.0;
    const Complex z = -cfl * high * backward;
    largest = std::max(largest, std::abs(1.0 + z + z * z / 2.0 + z * z * z / 6.0));
  }
  return largest;
}

TEST(Cweno3, IsLinearlyStableAtItsPromisedCflForWhateverWeights) {  // Eq. (T41)
  const double cfl = Cweno3{}.promised_cfl();
  for (int i = 0; i <= 20; ++i) {
    for (int j = 0; i + j <= 20; ++j) {
      EXPECT_LE(amplification(cfl, i / 20.0, j / 20.0), 1 + 16 * round_off) << i << ' ' << j;
    }
  }
  EXPECT_GE(amplification(0.9, 1, 0), 1.05);  // the line from below alone: the first to go
}

TEST(Cweno3, StaysWithinItsOwnParabolasAtASixth) {  // Eq. (T41): Simpson's rule has its weights at the faces
  std::mt19937 random{3};
  std::uniform_real_distribution<double> draw{0, 1};
  const Index n = 50;
  std::vector<double> u(50);
  for (double& value : u) value = draw(random);
  const Cweno3 reconstruction{};
  double lowest = 1;
  double highest = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    const auto [low, high] = reconstruction(State{u[(i + 49) % 50]}, State{u[i]}, State{u[(i + 1) % 50]});
    const double middle = (6 * u[i] - low[0] - high[0]) / 4;
    lowest = std::min({lowest, low[0], middle, high[0]});
    highest = std::max({highest, low[0], middle, high[0]});
  }

  Solver solver{Cartesian<1>{test::line(n, 0, 1)},
                Advection<1>{Vector<1>{1.0}},
                reconstruction,
                ForwardEuler{},
                {.cfl = 1.0 / 6}};
  solver.advance(u, solver.stable_time_step(u));

  for (const double value : u) {
    EXPECT_GE(value, lowest - 8 * round_off);
    EXPECT_LE(value, highest + 8 * round_off);
  }
}

TEST(Cweno3, LeavesTheBoundsBesideAJump) {  // where it fails: not TVD; by less than a thousandth of the jump
  std::vector<double> u(100, 0.0);
  std::fill(u.begin() + 25, u.begin() + 75, 1.0);
  Solver solver{
      Cartesian<1>{test::line(100, 0, 1)}, Advection<1>{Vector<1>{1.0}}, Cweno3{}, SspRk3{}, {.cfl = 0.4}};
  double lowest = 0;
  for (int i = 0; i < 20; ++i) {
    solver.advance(u, 0.05);
    lowest = std::min(lowest, *std::min_element(u.begin(), u.end()));
  }
  EXPECT_LE(lowest, -1e-4);
  EXPECT_GE(lowest, -1e-3);
}

TEST(Cweno3, RefusesScalesThatCannotBe) {
  for (const double scale : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
    EXPECT_EQ(test::message_of<InputError>([&] { Cweno3{scale}; }),
              "Cweno3: the scale must be positive and finite");
  }
}

static_assert(needs_equal_cells<Cweno3>);
static_assert(leaves_bounds<Cweno3>);

}  // namespace
}  // namespace scree::transport
