// The slotted disk, one turn, against a table of another code: 3 % of l1, and failure mode 8: without a
// limiter Gibbs' oscillations leave the bounds by an eighth, with one by nothing.

#include "planes.hpp"
#include "schemes.hpp"
#include "table.hpp"

#include <scree/transport/laws/advection.hpp>

#include <gtest/gtest.h>

namespace scree::transport {
namespace {

using test::pi;
using test::Row;

/// Solid rotation about (1/2, 1/2), once in 2 pi.
struct Rotation {
  Lattice<2> lattice;
  Advection<2> at(const Face& face) const noexcept {
    const Vector<2> x = lattice.position(lattice.site(face.owner));
    Vector<2> velocity = Vector<2>::Zero();  // along the axis alone, and the same all along it
    velocity[face.axis] = face.axis == 0 ? 0.5 - x[1] : x[0] - 0.5;
    return {velocity};
  }
};

bool is_in_disk(double x, double y) {
  const double dx = x - 0.5;
  const double dy = y - 0.75;
  return dx * dx + dy * dy < 0.15 * 0.15 && !(std::abs(dx) < 0.025 && y < 0.85);
}

std::vector<double> disk(const Lattice<2>& lattice) {
  constexpr int num_points = 8;
  std::vector<double> u;
  for (Index site = 0; site < lattice.num_sites(); ++site) {
    const Vector<2> x = lattice.position(lattice.site(site));
    int hits = 0;
    for (int i = 0; i < num_points; ++i) {
      for (int j = 0; j < num_points; ++j) {
        const double dx = ((i + 0.5) / num_points - 0.5) * lattice.spacing[0];
        const double dy = ((j + 0.5) / num_points - 0.5) * lattice.spacing[1];
        hits += is_in_disk(x[0] + dx, x[1] + dy) ? 1 : 0;
      }
    }
    u.push_back(hits / static_cast<double>(num_points * num_points));
  }
  return u;
}

class SlottedDisk : public ::testing::TestWithParam<Row> {};
TEST_P(SlottedDisk, IsThatOfTheTable) {
  const Row& row = GetParam();
  const Lattice<2> lattice = test::square(row.cells(), 0, 0, 1, false);
  const auto exact = disk(lattice);
  auto u = exact;
  BoxBoundaries<2, 1> open;
  for (auto& axis : open) axis.fill(Outflow{});
  const bool is_limited = row.text("scheme") != "centred";
  test::with_reconstruction(row.text("scheme"), [&](const auto& reconstruction) {
    // dt = 0.4 dx/a along each axis is 0.8 in the sum at the corners of the box, 0.57 on the disk's way.
    SemiDiscrete<Cartesian<2>, Rotation, std::remove_cvref_t<decltype(reconstruction)>, KurganovTadmor> rates{
        {lattice, Rotation{lattice}, reconstruction, {}, open}, 0.5, {}};
    test::advance_by_fastest_axis(rates, test::stages(row.text("time")), u, 2 * pi, 0.4);
  });
  const double lowest = *std::min_element(u.begin(), u.end());
  const double highest = *std::max_element(u.begin(), u.end());
  EXPECT_NEAR(test::l1(u, exact, lattice.spacing.prod()), row.number("l1"), 0.03 * row.number("l1"));
  EXPECT_NEAR(highest, row.number("highest"), 0.03);
  if (is_limited) {
    EXPECT_GE(lowest, -1e-12);  // some thousand steps of some ten roundings of values of at most 1
    EXPECT_LE(highest, 1 + 1e-12);
  } else {
    EXPECT_NEAR(lowest, row.number("lowest"), 0.03 * std::abs(row.number("lowest")));
  }
}
INSTANTIATE_TEST_SUITE_P(, SlottedDisk, ::testing::ValuesIn(test::table("slotted_disk.csv")), test::name_of);

}  // namespace
}  // namespace scree::transport
