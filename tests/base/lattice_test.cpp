#include <scree/lattice.hpp>

#include <gtest/gtest.h>

#include <type_traits>

namespace scree {
namespace {

/// A lattice of 3, 4, 5 sites with spacing 0.5, 0.25, 0.125 m, periodic along its first axis.
template <int D>
Lattice<D> small_lattice(Sites sites) {
  Lattice<D> lattice;
  lattice.sites = sites;
  for (int axis = 0; axis < D; ++axis) {
    lattice.count[static_cast<std::size_t>(axis)] = 3 + axis;
    lattice.spacing[axis] = 0.5 / (1 << axis);
    lattice.first[axis] = -1 + axis;
  }
  lattice.is_periodic[0] = true;
  return lattice;
}

template <class Dimension>
class EveryLattice : public ::testing::Test {
 protected:
  static constexpr int D = Dimension::value;
};
using Dimensions = ::testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 2>,
                                    std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(EveryLattice, Dimensions);

TYPED_TEST(EveryLattice, NumbersEachSiteOnce) {
  const auto lattice = small_lattice<TypeParam::value>(Sites::cells);

  for (Index index = 0; index < lattice.num_sites(); ++index) {
    const auto site = lattice.site(index);
    EXPECT_EQ(lattice.index(site), index);
    for (std::size_t axis = 0; axis < site.size(); ++axis) {
      EXPECT_TRUE(0 <= site[axis] && site[axis] < lattice.count[axis]);
    }
  }
}

TYPED_TEST(EveryLattice, StrideLeadsToTheNextSite) {
  const auto lattice = small_lattice<TypeParam::value>(Sites::cells);

  for (int axis = 0; axis < TypeParam::value; ++axis) {
    Indices<TypeParam::value> next{};
    next[static_cast<std::size_t>(axis)] = 1;
    EXPECT_EQ(lattice.index(next), lattice.stride(axis));
  }
}

TYPED_TEST(EveryLattice, PositionsAreOneSpacingApart) {
  const auto lattice = small_lattice<TypeParam::value>(Sites::cells);

  for (int axis = 0; axis < TypeParam::value; ++axis) {
    Indices<TypeParam::value> third{};
    third[static_cast<std::size_t>(axis)] = 2;
    EXPECT_EQ(lattice.position({}), lattice.first);
    EXPECT_EQ(lattice.position(third)[axis], lattice.first[axis] + 2 * lattice.spacing[axis]);
  }
}

TYPED_TEST(EveryLattice, VolumesFillTheBoxBetweenTheOuterNodes) {
  const auto lattice = small_lattice<TypeParam::value>(Sites::nodes);
  double box = 1;
  for (int axis = 0; axis < TypeParam::value; ++axis) {
    const Index count = lattice.count[static_cast<std::size_t>(axis)];
    box *= lattice.spacing[axis] * static_cast<double>(axis == 0 ? count : count - 1);  // axis 0 has no end
  }

  double sum = 0;
  for (Index i = 0; i < lattice.num_sites(); ++i) sum += lattice.volume(lattice.site(i));

  EXPECT_EQ(sum, box);  // powers of two: no rounding
}

TYPED_TEST(EveryLattice, CellsAreAllWhole) {
  const auto lattice = small_lattice<TypeParam::value>(Sites::cells);
  double whole = 1;
  for (int axis = 0; axis < TypeParam::value; ++axis) whole *= lattice.spacing[axis];

  for (Index i = 0; i < lattice.num_sites(); ++i) EXPECT_EQ(lattice.volume(lattice.site(i)), whole);
}

TYPED_TEST(EveryLattice, AreaTimesWidthIsVolume) {
  const auto lattice = small_lattice<TypeParam::value>(Sites::nodes);

  for (Index i = 0; i < lattice.num_sites(); ++i) {
    const auto site = lattice.site(i);
    for (int axis = 0; axis < TypeParam::value; ++axis) {
      EXPECT_EQ(lattice.face_area(site, axis) * lattice.width(site, axis), lattice.volume(site));
    }
  }
}

TEST(Lattice, FirstAxisIsFastest) {
  const auto lattice = small_lattice<3>(Sites::cells);

  EXPECT_EQ(lattice.stride(0), 1);
  EXPECT_EQ(lattice.stride(1), 3);
  EXPECT_EQ(lattice.stride(2), 12);
}

}  // namespace
}  // namespace scree
