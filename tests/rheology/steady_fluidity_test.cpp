#include "fluidity_fields.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <random>
#include <string>

namespace scree::rheology {
namespace {

constexpr NonlocalFluidity beads = typical<NonlocalFluidity>();

template <class Dimension>
class SteadyFluidity : public ::testing::Test {
 protected:
  static constexpr int dimensions = Dimension::value;
};
using Dimensions = ::testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 2>,
                                    std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(SteadyFluidity, Dimensions);

/// Rounding of a direct solve of N equations: N times the worst of a few operations, by the condition number,
/// which is 1 + 4 D (xi/h)^2 at most.
[[nodiscard]] double solve_rounding(Index num_cells, int dimensions, double length_in_cells) {
  return 10 * static_cast<double>(num_cells) * round_off *
         (1 + 4 * dimensions * length_in_cells * length_in_cells);
}

TYPED_TEST(SteadyFluidity, IsLocalInUniformShear) {  // Eq. (R176)
  constexpr int D = TestFixture::dimensions;
  Indices<D> count{};
  count.fill(5);
  const auto cells = cells_of<D>(count, 2e-3);
  const OwnedFields fields{cells.num_sites(), beads.mu_s + 0.1};
  const double expected = beads.local_fluidity(beads.mu_s + 0.1, 500.0, 1e-3);

  const auto g = steady<D>(beads, cells, {}, fields);

  const double xi = beads.cooperativity_length(beads.mu_s + 0.1, 1e-3);
  for (const double value : g) {
    EXPECT_NEAR(value, expected, solve_rounding(cells.num_sites(), D, xi / 2e-3) * expected);
  }
}

/// What does not vary across an axis does not feel it: any dimension, along any axis, is one dimension.
TYPED_TEST(SteadyFluidity, IsThatOfOneDimensionAlongEachAxis) {
  constexpr int D = TestFixture::dimensions;
  constexpr Index n = 24;
  const double h = 1e-3;
  const double mu = beads.mu_s - 0.02;
  const auto line = steady<1>(beads, cells_of<1>({n}, h), {{{3.0, std::nullopt}}}, OwnedFields{n, mu});
  for (int axis = 0; axis < D; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    Indices<D> count{};
    count.fill(3);
    count[a] = n;
    FluidityEnds<D> ends{};
    ends[a][0] = 3.0;
    const auto cells = cells_of<D>(count, h);

    const auto g = steady<D>(beads, cells, ends, OwnedFields{cells.num_sites(), mu});

    const double xi = beads.cooperativity_length(mu, 1e-3);
    for (Index cell = 0; cell < cells.num_sites(); ++cell) {
      EXPECT_NEAR(g[static_cast<std::size_t>(cell)], line[static_cast<std::size_t>(cells.site(cell)[a])],
                  solve_rounding(cells.num_sites(), D, xi / h) * 3);
    }
  }
}

/// A point source felt at another point is felt alike the other way round.
TYPED_TEST(SteadyFluidity, IsReciprocal) {
  constexpr int D = TestFixture::dimensions;
  Indices<D> count{};
  count.fill(6);
  const auto cells = cells_of<D>(count, 1e-3);
  Indices<D> here{};
  Indices<D> there{};
  here.fill(1);
  there.fill(4);
  const auto felt = [&](const Indices<D>& source, const Indices<D>& point) {
    OwnedFields fields{cells.num_sites(), beads.mu_s - 0.01};
    fields.friction[static_cast<std::size_t>(cells.index(source))] = beads.mu_s + 0.01;  // of the same xi
    return steady<D>(beads, cells, {}, fields)[static_cast<std::size_t>(cells.index(point))];
  };

  const double expected = felt(here, there);

  EXPECT_GT(expected, 0);
  EXPECT_NEAR(
      felt(there, here), expected,
      solve_rounding(cells.num_sites(), D, 4.8) * beads.local_fluidity(beads.mu_s + 0.01, 500.0, 1e-3));
}

/// No cell is negative, to the last bit, and none above the largest source.
TYPED_TEST(SteadyFluidity, IsBoundedByItsSources) {
  constexpr int D = TestFixture::dimensions;
  Indices<D> count{};
  count.fill(D == 1 ? 200 : 8);
  const auto cells = cells_of<D>(count, 1e-3);
  std::mt19937 random{3};
  std::uniform_real_distribution<double> draw{0, 1};
  OwnedFields fields{cells.num_sites(), 0};
  double bound = 0;
  for (std::size_t c = 0; c < fields.friction.size(); ++c) {
    fields.friction[c] = draw(random);
    fields.grain_size[c] = 1e-4 + 1e-2 * draw(random);
    fields.pressure[c] = 1 + 1e4 * draw(random);
    bound =
        std::max(bound, beads.local_fluidity(fields.friction[c], fields.pressure[c], fields.grain_size[c]));
  }

  const auto g = steady<D>(beads, cells, {}, fields);

  for (const double value : g) EXPECT_TRUE(value >= 0 && value <= bound * (1 + 1e-9)) << value;
}

TYPED_TEST(SteadyFluidity, SeesMaterialOnly) {  // a full half of a box is a smaller box
  constexpr int D = TestFixture::dimensions;
  Indices<D> whole{};
  whole.fill(6);
  Indices<D> half = whole;
  half[D - 1] = 3;
  const auto cells = cells_of<D>(whole, 1e-3);
  const auto small = cells_of<D>(half, 1e-3);
  FluidityEnds<D> ends{};
  ends[D - 1][0] = 2.0;
  OwnedFields fields{cells.num_sites(), beads.mu_s - 0.01};
  std::vector<bool> is_occupied(fields.friction.size(), true);
  for (auto c = static_cast<std::size_t>(small.num_sites()); c < is_occupied.size(); ++c) {
    is_occupied[c] = false;
    fields.friction[c] = fields.pressure[c] = std::numeric_limits<double>::quiet_NaN();
  }
  std::vector<double> g(fields.friction.size(), 7);

  FluidityGrid<D>{beads, cells, is_occupied, ends}.solve_steady(fields.view(), g);

  const auto expected = steady<D>(beads, small, ends, OwnedFields{small.num_sites(), beads.mu_s - 0.01});
  for (std::size_t c = 0; c < g.size(); ++c) EXPECT_EQ(g[c], c < expected.size() ? expected[c] : 0);
}

/// Error of a layer of 20 grains with fluidity 1 held at its base and mu < mu_s:
/// g = cosh((H - y)/xi)/cosh(H/xi).
[[nodiscard]] double decay_error(Index num_cells) {
  const double height = 0.02;
  const double mu = beads.mu_s - 0.02;
  const double xi = beads.cooperativity_length(mu, 1e-3);
  const double h = height / static_cast<double>(num_cells);
  const auto g =
      steady<1>(beads, cells_of<1>({num_cells}, h), {{{1.0, std::nullopt}}}, OwnedFields{num_cells, mu});
  double worst = 0;
  for (Index c = 0; c < num_cells; ++c) {
    const double y = (static_cast<double>(c) + 0.5) * h;
    const double exact = std::cosh((height - y) / xi) / std::cosh(height / xi);
    worst = std::max(worst, std::abs(g[static_cast<std::size_t>(c)] - exact));
  }
  return worst;
}

TEST(SteadyFluidity1D, CreepsBelowMuSWithAnExponentialProfile) {  // Eqs. (R175), (R176)
  const double coarse = decay_error(100);
  const double fine = decay_error(200);

  // In units of (h/xi)^2, with h/xi = 0.0295: an eighth from the half cell at the base, where a quarter of
  // g'' is missed, and at most 1/(24 e) from the length of the decay.
  EXPECT_LT(fine, (1.0 / 8 + 1.0 / 24) * 0.0295 * 0.0295);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.059);  // the first cell is part of h/xi nearer
}

/// A band of half-width w above mu_s between creeping material, symmetric: below w the exact solution is
/// g_loc - a cosh(y/xi_1), above it c cosh((H - y)/xi_2); value and slope are continuous.
[[nodiscard]] double band_error(Index num_cells) {
  const double height = 0.04;
  const double width = 0.01;
  const double inside = beads.mu_s + 0.03;
  const double outside = beads.mu_s - 0.01;
  const double h = height / static_cast<double>(num_cells);
  const double xi_1 = beads.cooperativity_length(inside, 1e-3);
  const double xi_2 = beads.cooperativity_length(outside, 1e-3);
  const double g_loc = beads.local_fluidity(inside, 500.0, 1e-3);
  const double slopes = xi_2 / xi_1 * std::sinh(width / xi_1) / std::tanh((height - width) / xi_2);
  const double a = g_loc / (std::cosh(width / xi_1) + slopes);
  const double c = a * slopes / std::cosh((height - width) / xi_2);
  OwnedFields fields{num_cells, outside};
  for (Index i = 0; i < num_cells / 4; ++i) fields.friction[static_cast<std::size_t>(i)] = inside;

  const auto g = steady<1>(beads, cells_of<1>({num_cells}, h), {}, fields);

  double worst = 0;
  for (Index i = 0; i < num_cells; ++i) {
    const double y = (static_cast<double>(i) + 0.5) * h;
    const double exact = y < width ? g_loc - a * std::cosh(y / xi_1) : c * std::cosh((height - y) / xi_2);
    worst = std::max(worst, std::abs(g[static_cast<std::size_t>(i)] - exact));
  }
  return worst / g_loc;
}

TEST(SteadyFluidity1D, LetsABandOfShearDragItsNeighbours) {  // Eq. (R176)
  const double coarse = band_error(160);
  const double fine = band_error(320);

  // In units of (h/xi_1)^2, with h/xi_1 = 0.0451: an eighth of the jump of g'', which is below g_loc/xi_1^2,
  // and at most 1/(24 e) from the lengths of decay on either side.
  EXPECT_LT(fine, (1.0 / 8 + 1.0 / 24) * 0.0451 * 0.0451);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.09);  // cells beside the jump are part of h/xi_1 nearer
}

/// The local law has no flow at all there: that is what the nonlocal one is for.
TEST(SteadyFluidity1D, FlowsWhereTheLocalLawDoesNot) {
  const Index n = 40;
  OwnedFields fields{n, beads.mu_s - 0.01};
  for (std::size_t i = 0; i < 10; ++i) fields.friction[i] = beads.mu_s + 0.03;

  const auto g = steady<1>(beads, cells_of<1>({n}, 1e-3), {}, fields);

  for (std::size_t i = 10; i < 40; ++i) {
    EXPECT_EQ(beads.local_fluidity(fields.friction[i], 500.0, 1e-3), 0);
    EXPECT_GT(g[i], 0);
  }
}

TEST(SteadyFluidity1D, IsLocalForASmallAmplitude) {  // A -> 0
  const Index n = 50;
  const double h = 1e-3;
  OwnedFields fields{n, 0};
  double sharpest = 0;  // largest xi
  for (std::size_t i = 0; i < fields.friction.size(); ++i) {
    fields.friction[i] = beads.mu_s + 0.1 * std::cos(0.7 * static_cast<double>(i));
  }
  NonlocalFluidity local = beads;
  local.amplitude = 1e-6;
  double largest_local = 0;
  for (const double mu : fields.friction) {
    sharpest = std::max(sharpest, local.cooperativity_length(mu, 1e-3));
    largest_local = std::max(largest_local, local.local_fluidity(mu, 500.0, 1e-3));
  }

  const auto g = steady<1>(local, cells_of<1>({n}, h), {}, fields);

  // g - g_loc = xi^2 times a second difference of values between 0 and the largest.
  for (std::size_t i = 0; i < g.size(); ++i) {
    EXPECT_NEAR(g[i], local.local_fluidity(fields.friction[i], 500.0, 1e-3),
                2 * (sharpest / h) * (sharpest / h) * largest_local + 10 * round_off * largest_local);
  }
}

/// Grains of twice the size on a mesh twice as large make the same picture: xi is in proportion to the size.
TEST(SteadyFluidity1D, ScalesWithTheGrains) {
  const Index n = 30;
  const double mu = beads.mu_s - 0.02;
  const FluidityEnds<1> ends{{{1.0, std::nullopt}}};

  const auto fine = steady<1>(beads, cells_of<1>({n}, 1e-3), ends, OwnedFields{n, mu, 500, 1e-3});
  const auto coarse = steady<1>(beads, cells_of<1>({n}, 2e-3), ends, OwnedFields{n, mu, 500, 2e-3});

  EXPECT_EQ(fine, coarse);  // powers of two do not round
}

[[nodiscard]] std::string refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

TEST(FluidityGrid, NamesWhatDoesNotFit) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto cells = cells_of<1>({3}, 1e-3);
  const auto solve = [&](const OwnedFields& fields, std::size_t length = 3) {
    return refusal([&] {
      std::vector<double> g(length);
      grid_of<1>(beads, cells, {}).solve_steady(fields.view(), g);
    });
  };
  OwnedFields no_pressure{3, 0.3};
  no_pressure.pressure[1] = 0;
  OwnedFields no_size{3, 0.3};
  no_size.grain_size[2] = nan;

  EXPECT_EQ(solve(OwnedFields{3, 0.3}), "");
  EXPECT_EQ(solve(OwnedFields{3, -0.3}),
            "FluidityGrid: friction of cell 0 is -0.3, must be finite and at least 0");
  EXPECT_EQ(solve(no_pressure), "FluidityGrid: pressure of cell 1 is 0, must be finite and above 0 Pa");
  EXPECT_EQ(solve(no_size), "FluidityGrid: grain size of cell 2 is nan, must be finite and above 0 m");
  EXPECT_EQ(solve(OwnedFields{2, 0.3}), "FluidityGrid: friction has 2 values for 3 cells");
  EXPECT_EQ(solve(OwnedFields{3, 0.3}, 4), "FluidityGrid: fluidity has 4 values for 3 cells");
  EXPECT_EQ(solve(OwnedFields{3, beads.mu_s}),
            "FluidityGrid: where the friction is mu_s all over and no end is held, the steady fluidity is "
            "left open");
}

TEST(FluidityGrid, NamesEndsAndCellsThatCannotBe) {
  const auto cells = cells_of<1>({3}, 1e-3);
  const auto around = cells_of<1>({3}, 1e-3, true);
  const auto nodes = CartesianGrid<1>{Vector<1>{0.0}, Vector<1>{1.0}, {3}, {false}}.nodes();
  const FluidityEnds<1> held{{{1.0, std::nullopt}}};

  EXPECT_EQ(refusal([&] {
              static_cast<void>(grid_of<1>(beads, cells, {{{std::nullopt, -1.0}}}));
            }),
            "FluidityGrid: a fluidity that is held must be finite and at least 0");
  EXPECT_EQ(refusal([&] { static_cast<void>(grid_of<1>(beads, around, held)); }),
            "FluidityGrid: a periodic axis has no end to hold the fluidity at");
  EXPECT_EQ(refusal([&] { static_cast<void>(grid_of<1>(beads, nodes, {})); }),
            "FluidityGrid: the lattice must be that of cells");
  EXPECT_EQ(refusal([&] {
              FluidityGrid<1>(beads, cells, {true, false}, {});
            }),
            "FluidityGrid: occupation has 2 values for 3 cells");
  EXPECT_EQ(refusal([&] { FluidityGrid<1>(beads, cells, std::vector<bool>(3, false), {}); }),
            "FluidityGrid: no cell holds material");
}

}  // namespace
}  // namespace scree::rheology
