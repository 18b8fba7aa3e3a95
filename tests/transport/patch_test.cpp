// A grid cut into patches: nothing is lost or counted twice, and weights in single precision are no loss.

#include "meshes.hpp"

#include <scree/transport/detail/cell_slopes.hpp>
#include <scree/transport/detail/patch.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace scree::transport {
namespace {

using Patches = std::vector<detail::Patch<2>>;

/// 5000 triangles: four patches.
Polygonal many_cells(double width = 1) {
  return Polygonal{make_mesh({.high = Vector<2>::Constant(width), .count = {50, 50}, .perturbation = 0.2})};
}

Patches patches_of(const Polygonal& grid) {
  return detail::make_patches<2>(detail::GridParts<2>{grid}, {2, true, false});
}

/// The places of a patch's cells, as states: their gradient is the identity.
CellStates<2> places(const Polygonal& grid, const detail::Patch<2>& patch) {
  CellStates<2> result{static_cast<Index>(patch.cells.size())};
  for (std::size_t i = 0; i < patch.cells.size(); ++i) {
    detail::values_of<2>(result, static_cast<Index>(i)) = grid.centre(patch.cells[i]);
  }
  return result;
}

/// The largest error of all gradients of the places, with the patches' corrections or without.
double gradient_error(const Polygonal& grid, bool is_corrected) {
  double error = 0;
  for (detail::Patch<2> patch : patches_of(grid)) {
    for (std::size_t i = 0; i < patch.widths.size() && !is_corrected; ++i) {
      patch.corrections[i] = Matrix<2>::Identity() / patch.widths[i];
    }
    const CellStates<2> states = places(grid, patch);
    for (Index cell = 0; cell < patch.num_near; ++cell) {
      const auto gradient = detail::fit<2, 2>(patch, states, cell).gradient;
      error =
          std::max({error, (gradient[0] - Vector<2>{1, 0}).norm(), (gradient[1] - Vector<2>{0, 1}).norm()});
    }
  }
  return error;
}

TEST(Patch, OwnsEachCellOnce) {
  const Polygonal grid = many_cells();
  const Patches patches = patches_of(grid);

  std::vector<int> num_owners(static_cast<std::size_t>(grid.num_cells()));
  for (const auto& patch : patches) {
    for (Index i = 0; i < patch.num_own; ++i) {
      ++num_owners[static_cast<std::size_t>(patch.cells[static_cast<std::size_t>(i)])];
    }
  }

  EXPECT_GT(patches.size(), 1U);
  EXPECT_EQ(num_owners, std::vector<int>(num_owners.size(), 1));
}

TEST(Patch, GivesWhatPassesAFaceToBothCells) {  // once to each, also where they are in two patches
  const Polygonal grid = many_cells();

  std::vector<int> num_cells(static_cast<std::size_t>(grid.num_faces()));
  std::vector<double> balance(num_cells.size());
  for (const auto& patch : patches_of(grid)) {
    for (Index i = 0; i < patch.num_own; ++i) {
      for (const detail::SideShare& side : patch.shares_of(i)) {
        const auto face = static_cast<std::size_t>(patch.original[static_cast<std::size_t>(side.face)]);
        ++num_cells[face];
        balance[face] += side.rate * grid.volume(patch.cells[static_cast<std::size_t>(i)]);
      }
    }
  }

  for (Index i = 0; i < grid.num_faces(); ++i) {
    const GridFace<2>& face = grid.face(i);
    const bool is_inner = face.neighbour != no_site;
    ASSERT_EQ(num_cells[static_cast<std::size_t>(i)], is_inner ? 2 : 1) << i;
    // Two quotients and two products.
    ASSERT_NEAR(balance[static_cast<std::size_t>(i)], is_inner ? 0 : -face.area, 4 * face.area * round_off);
  }
}

TEST(Patch, MakesWeightsOfSinglePrecisionExactForLinearFields) {  // Eq. (T32a)
  const Polygonal grid = many_cells();
  constexpr double float_round_off = std::numeric_limits<float>::epsilon() / 2;

  // Twenty cells at most, in places up to 1 whose differences are rounded by two round-offs of 1; weights are
  // below the square root of 1/0.05 over the distance.
  const double roundings = 20 * 2 * std::sqrt(1 / 0.05) * test::largest_area_per_volume(grid);
  EXPECT_LE(gradient_error(grid, true), roundings * round_off);
  // Nine weights of single precision, rounded at random; among 5000 cells there are some that do not cancel.
  EXPECT_GE(gradient_error(grid, false), float_round_off / 2);
}

TEST(Patch, HasWeightsWithoutAUnit) {  // 1/1e-45 m is beyond single precision
  const double width = 1e-45;
  const Polygonal grid = many_cells(width);

  const double roundings = 20 * 2 * std::sqrt(1 / 0.05) * width * test::largest_area_per_volume(grid);
  EXPECT_LE(gradient_error(grid, true), roundings * round_off);
}

}  // namespace
}  // namespace scree::transport
