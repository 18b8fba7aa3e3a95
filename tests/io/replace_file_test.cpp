#include "child.hpp"
#include "scratch.hpp"

#include <scree/error.hpp>
#include <scree/io/replace_file.hpp>

namespace scree::io {
namespace {

TEST(ReplaceFile, PutsTheNewBytesInPlaceOfTheOldAndLeavesNothingElse) {
  const test::Scratch folder;
  replace_file(folder / "summary.json", "a long old text");

  replace_file(folder / "summary.json", std::string_view{"new\0text", 8});

  EXPECT_EQ(test::read_bytes(folder / "summary.json"), (std::string{"new\0text", 8}));
  EXPECT_FALSE(std::filesystem::exists(folder / "summary.json.partial"));
}

TEST(ReplaceFile, KeepsTheOldFileOnAFullDisk) {
  const test::Scratch folder;
  const std::string old_text(100, 'o');
  replace_file(folder / "summary.json", old_text);
  const std::string message = (folder / "summary.json").string() + ": cannot be written: File too large";

  EXPECT_TRUE(test::holds_on_full_disk(500, [&] {
    return test::throws<RunError>([&] { replace_file(folder / "summary.json", std::string(501, 'n')); },
                                  message.c_str());
  }));

  EXPECT_EQ(test::read_bytes(folder / "summary.json"), old_text);
  EXPECT_FALSE(std::filesystem::exists(folder / "summary.json.partial"));
}

TEST(ReplaceFile, NamesTheFileItCannotMake) {
  const test::Scratch folder;
  const std::filesystem::path path = folder / "absent/summary.json";

  const std::string message = test::message_of<RunError>([&] { replace_file(path, "text"); });

  EXPECT_EQ(message, path.string() + ": cannot be written: No such file or directory");
}

}  // namespace
}  // namespace scree::io
