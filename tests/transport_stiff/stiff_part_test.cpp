#include "problems.hpp"

#include <scree/transport/grids/occupied_cells.hpp>
#include <scree/transport/limiters.hpp>
#include <scree/transport/reconstructions.hpp>
#include <scree/transport_stiff/convective_part.hpp>
#include <scree/transport_stiff/stiff_part.hpp>

#include <gtest/gtest.h>

namespace scree::transport {
namespace {

/// With a source that knows place and time.
struct Reacting : test::NonlinearDiffusion {
  template <int D>
  State source(const State& u, const Vector<D>& x, double t) const noexcept {
    return {-3 * (u[0] - std::sin(x[0] + t))};
  }
};
static_assert(Diffusive<Reacting> && HasSource<Reacting, 2>);
static_assert(!Diffusive<ConvectivePart<Reacting>> && !HasSource<ConvectivePart<Reacting>, 2>);
static_assert(PointLaw<ConvectivePart<Reacting>, 2>);

/// A law that differs from face to face: diffusion grows with the number of the face's owner.
struct ByFace {
  static constexpr int num_components = 1;
  [[nodiscard]] test::NonlinearDiffusion at(const Face& face) const noexcept {
    return {0.1 + 0.01 * static_cast<double>(face.owner)};
  }
};
static_assert(Diffusive<PointLawOf<ByFace>>);
static_assert(!Diffusive<PointLawOf<ConvectivePart<ByFace>>>);

/// 9 x 7 nodes with half volumes at the walls of one axis, of different masses, some empty.
OccupiedCells<2> partly_filled() {
  Lattice<2> lattice = test::cube<2>(9);
  lattice.count = {9, 7};
  lattice.is_periodic = {false, true};
  lattice.sites = Sites::nodes;
  OccupiedCells<2> grid{lattice};
  std::vector<double> masses;
  for (Index site = 0; site < lattice.num_sites(); ++site) {
    masses.push_back(site % 5 == 3 ? 0 : 0.01 * static_cast<double>(1 + site % 4));
  }
  grid.set_masses(masses);
  return grid;
}

template <class Law>
void expect_both_parts_make_the_whole(const Law& law) {
  using Reconstruct = PiecewiseLinear<Minmod>;
  const OccupiedCells<2> grid = partly_filled();
  const Index n = grid.lattice().num_sites();
  std::vector<double> u;
  for (Index site = 0; site < n; ++site) u.push_back(std::sin(static_cast<double>(site * site)));
  Fields<1> fields{n};
  fields.gather(u, {});
  Fields<1> whole{n};
  Fields<1> convective{n};
  std::vector<double> stiff(static_cast<std::size_t>(n));

  SemiDiscrete<OccupiedCells<2>, Law, Reconstruct, KurganovTadmor>{{grid, law, {}, {}, {}}, 0.5, {}}(
      fields, whole, 0.7);
  SemiDiscrete<OccupiedCells<2>, ConvectivePart<Law>, Reconstruct, KurganovTadmor>{
      {grid, {law}, {}, {}, {}}, 0.5, {}}(fields, convective, 0.7);
  stiff_rate(grid, law, Threads{}, 0.7, u, stiff);

  double largest = 0;
  for (Index site = 0; site < n; ++site) largest = std::max(largest, std::abs(whole[site][0]));
  for (Index site = 0; site < n; ++site) {  // thirty operations
    EXPECT_NEAR(convective[site][0] + stiff[static_cast<std::size_t>(site)], whole[site][0],
                30 * round_off * largest);
  }
}

TEST(StiffPart, AndTheConvectivePartMakeTheWholeRate) {
  expect_both_parts_make_the_whole(Reacting{{0.3}});
  expect_both_parts_make_the_whole(ByFace{});
}

TEST(StiffPart, OfDiffusionAddsUpToNothing) {
  const OccupiedCells<2> grid = partly_filled();
  const Lattice<2>& lattice = grid.lattice();
  std::vector<double> u;
  for (Index site = 0; site < lattice.num_sites(); ++site) u.push_back(std::cos(static_cast<double>(site)));
  std::vector<double> rate(u.size());

  stiff_rate(grid, ByFace{}, Threads{}, 0, u, rate);

  double sum = 0;
  double size = 0;
  for (Index site = 0; site < lattice.num_sites(); ++site) {
    const double mass = grid.density(site) * lattice.volume(lattice.site(site));
    sum += mass * rate[static_cast<std::size_t>(site)];
    size += mass * std::abs(rate[static_cast<std::size_t>(site)]);
  }
  EXPECT_GT(size, 0);
  EXPECT_NEAR(sum, 0, 63 * round_off * size);  // of as many terms
}

}  // namespace
}  // namespace scree::transport
