#include "messages.hpp"

#include <scree/mpm/column.hpp>

#include <array>
#include <cstdint>

namespace scree::mpm {
namespace {

Column three_pairs() {
  Column column{{"velocity", "v", "m/s"}, 2};
  column.resize(3);
  for (std::size_t i = 0; i < 6; ++i) column.values()[i] = static_cast<double>(i);
  return column;
}

TEST(Column, KeepsEachComponentInOnePiece) {
  const Column column = three_pairs();

  EXPECT_EQ(column.size(), 3);
  EXPECT_EQ(column.component(0)[2], 2);
  EXPECT_EQ(column.component(1)[0], 3);
}

TEST(Column, IsZeroWhenItHasBeenResized) {
  Column column = three_pairs();

  column.resize(4);

  EXPECT_EQ(column.values().size(), 8);
  for (const double value : column.values()) EXPECT_EQ(value, 0);
}

TEST(Column, TakesEachValueFromItsSource) {
  Column column = three_pairs();
  const std::array<Index, 4> source{2, 0, 0, 1};

  column.reorder(source);

  const std::array<double, 8> expected{2, 0, 0, 1, 5, 3, 3, 4};
  ASSERT_EQ(column.size(), 4);
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(column.values()[i], expected[i]);
}

TEST(Column, TakesFewerValuesThanItHad) {
  Column column = three_pairs();
  const std::array<Index, 2> source{2, 1};

  column.reorder(source);

  const std::array<double, 4> expected{2, 1, 5, 4};
  ASSERT_EQ(column.values().size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(column.values()[i], expected[i]);
}

TEST(Column, BeginsOnACacheLine) {
  const Column column = three_pairs();

  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(column.component(0)) % 64, 0);
}

TEST(Column, AppendsEachComponentToItsOwn) {
  Column column = three_pairs();

  column.append(three_pairs());

  const std::array<double, 12> expected{0, 1, 2, 0, 1, 2, 3, 4, 5, 3, 4, 5};
  ASSERT_EQ(column.size(), 6);
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(column.values()[i], expected[i]);
}

TEST(Column, RefusesToAppendOtherComponents) {
  Column column = three_pairs();

  EXPECT_EQ(message_of<InputError>([&] {
              column.append(Column{{"mass", "m", "kg"}, 1});
            }),
            "Column '" + column.quantity().name + "': what is appended must have as many components");
}

TEST(Column, RefusesToHaveNoComponent) {
  EXPECT_EQ(message_of<InputError>([] {
              Column({"velocity", "v", "m/s"}, 0);
            }),
            "Column 'velocity': must have at least one component");
}

}  // namespace
}  // namespace scree::mpm
