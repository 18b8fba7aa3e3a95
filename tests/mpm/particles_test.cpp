#include "messages.hpp"

#include <scree/mpm/particles.hpp>

namespace scree::mpm {
namespace {

/// Position D, velocity V, its gradient and the stress V D each, mass, density and id.
template <int D, int V>
constexpr std::size_t bare_bytes = (D + V + 2 * V * D + 3) * sizeof(double);

TEST(Particles, CostTheBytesOfTheirColumnsAndNoMore) {
  EXPECT_EQ((Particles<1, 1>{}.bytes_per_particle()), (bare_bytes<1, 1>));
  EXPECT_EQ((Particles<1, 2>{}.bytes_per_particle()), (bare_bytes<1, 2>));
  EXPECT_EQ((Particles<2, 2>{}.bytes_per_particle()), (bare_bytes<2, 2>));
  EXPECT_EQ((Particles<3, 3>{}.bytes_per_particle()), (bare_bytes<3, 3>));
}

TEST(Particles, CostWhatAnAddedColumnCosts) {
  Particles<2> particles;

  particles.add_column({"size_fractions", "phi", "-"}, 5);

  EXPECT_EQ(particles.bytes_per_particle(), (bare_bytes<2, 2>)+5 * sizeof(double));
}

TEST(Particles, ResizeEveryColumnAlike) {
  Particles<2> particles;
  const std::size_t early = particles.add_column({"early", "e", "-"}, 1);

  particles.resize(7);
  const std::size_t late = particles.add_column({"late", "l", "-"}, 3);

  EXPECT_EQ(particles.column(early).size(), 7);
  EXPECT_EQ(particles.column(late).size(), 7);
  particles.for_each_column([](const Column& column) { EXPECT_EQ(column.size(), 7); });
}

TEST(Particles, HaveOneColumnForOneName) {
  Particles<2> particles;

  const std::size_t first = particles.add_column({"grain_size", "s_a", "m"}, 1);
  const std::size_t again = particles.add_column({"grain_size", "s_a", "m"}, 1);

  EXPECT_EQ(first, again);
  EXPECT_EQ(particles.find_column("grain_size", "a test"), first);
}

TEST(Particles, RefuseTwoColumnsOfOneName) {
  Particles<2> particles;
  particles.add_column({"grain_size", "s_a", "m"}, 1);
  const std::string expected = "Particles: two different columns are named 'grain_size'";

  EXPECT_EQ(message_of<InputError>([&] { particles.add_column({"grain_size", "s_a", "m"}, 2); }), expected);
  EXPECT_EQ(message_of<InputError>([&] { particles.add_column({"grain_size", "s_a", "mm"}, 1); }), expected);
}

TEST(Particles, NameWhoMissesAColumn) {
  const Particles<2> particles;

  EXPECT_EQ(
      message_of<InputError>([&] { static_cast<void>(particles.find_column("grain_size", "the wall")); }),
      "the wall needs the column 'grain_size', which no part of this run provides");
}

}  // namespace
}  // namespace scree::mpm
