#include "scratch.hpp"

#include <scree/error.hpp>
#include <scree/io/faults.hpp>

namespace scree::io {
namespace {

TEST(Faults, ThrowNothingWhereThereIsNone) {
  const Faults faults;

  EXPECT_TRUE(faults.is_empty());
  EXPECT_NO_THROW(faults.throw_if_any());
}

TEST(Faults, AreReportedTogetherInTheOrderOfTheFileThoseWithoutALineLast) {
  Faults faults;
  faults.add(0, "--set a=1: first without a line");
  faults.add(7, "f:7: seventh");
  faults.add(2, "f:2: second");
  faults.add(0, "f: second without a line");
  faults.add(7, "f:7: seventh too");

  const std::string message = test::message_of<InputError>([&] { faults.throw_if_any(); });

  EXPECT_EQ(message,
            "f:2: second\n"
            "f:7: seventh\n"
            "f:7: seventh too\n"
            "--set a=1: first without a line\n"
            "f: second without a line");
}

}  // namespace
}  // namespace scree::io
