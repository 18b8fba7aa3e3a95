#include "child.hpp"
#include "scratch.hpp"

#include <scree/error.hpp>
#include <scree/io/hdf5/file.hpp>
#include <scree/io/replace_file.hpp>

#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace scree::io {
namespace {

using test::message_of;

const std::vector<double> doubles{0.1, -0.0, 1.0 / 3, 5e-324, std::numeric_limits<double>::infinity(), 6};
const std::vector<std::int64_t> integers{0, -1, std::numeric_limits<std::int64_t>::min(),
                                         std::numeric_limits<std::int64_t>::max()};

void write_sample(const std::filesystem::path& path) {
  Hdf5File file = Hdf5File::create(path);
  file.create_group("/group");
  file.write("/group/matrix", doubles, {.num_rows = 3, .num_columns = 2, .rank = 2});
  file.write("/integers", integers);
  file.write_text("/text", "[mesh]\ncells = 51  # µm\n");
  file.write_attribute("/group/matrix", "unit", std::string{"m/s²"});
  file.write_attribute("/", "time", 0.1);
  file.write_attribute("/group", "step", std::int64_t{1} << 62);
  file.close();
}

TEST(Hdf5File, ReadsBackEveryBitThatItWrote) {
  const test::Scratch folder;
  write_sample(folder / "sample.h5");

  const Hdf5File file = Hdf5File::open(folder / "sample.h5");

  const std::vector<double> read = file.read_doubles("/group/matrix");
  ASSERT_EQ(read.size(), doubles.size());
  EXPECT_EQ(std::memcmp(read.data(), doubles.data(), sizeof(double) * read.size()), 0);
  EXPECT_EQ(file.shape("/group/matrix"), (Shape{.num_rows = 3, .num_columns = 2, .rank = 2}));
  EXPECT_EQ(file.read_integers("/integers"), integers);
  EXPECT_EQ(file.shape("/integers"), (Shape{.num_rows = 4, .num_columns = 1, .rank = 1}));
  EXPECT_EQ(file.read_text("/text"), "[mesh]\ncells = 51  # µm\n");
  EXPECT_EQ(file.text_attribute("/group/matrix", "unit"), "m/s²");
  EXPECT_EQ(file.double_attribute("/", "time"), 0.1);
  EXPECT_EQ(file.integer_attribute("/group", "step"), std::int64_t{1} << 62);
}

TEST(Hdf5File, ReadsBackWhatIsEmpty) {
  const test::Scratch folder;
  Hdf5File written = Hdf5File::create(folder / "empty.h5");
  written.write("/none", std::span<const double>{});
  written.write("/rows", std::span<const std::int64_t>{}, {.num_rows = 0, .num_columns = 3, .rank = 2});
  written.write_text("/text", "");
  written.close();

  const Hdf5File file = Hdf5File::open(folder / "empty.h5");

  EXPECT_TRUE(file.read_doubles("/none").empty());
  EXPECT_EQ(file.shape("/rows"), (Shape{.num_rows = 0, .num_columns = 3, .rank = 2}));
  EXPECT_EQ(file.read_text("/text"), "");
}

TEST(Hdf5File, ListsWhatItHolds) {
  const test::Scratch folder;
  write_sample(folder / "sample.h5");

  const Hdf5File file = Hdf5File::open(folder / "sample.h5");

  EXPECT_EQ(file.children("/"), (std::vector<std::string>{"group", "integers", "text"}));
  EXPECT_TRUE(file.contains("/") && file.contains("/group/matrix") && file.has_attribute("/", "time"));
  EXPECT_FALSE(file.contains("/matrix") || file.contains("/no/group") || file.has_attribute("/", "unit"));
}

TEST(Hdf5File, MakesTheSameBytesFromTheSameCalls) {
  const test::Scratch folder;
  write_sample(folder / "one.h5");
  write_sample(folder / "two.h5");

  EXPECT_EQ(test::read_bytes(folder / "one.h5"), test::read_bytes(folder / "two.h5"));
}

TEST(Hdf5File, AppendsToWhatIsThere) {
  const test::Scratch folder;
  write_sample(folder / "sample.h5");
  Hdf5File appended = Hdf5File::append(folder / "sample.h5");
  appended.write("/more", doubles);
  appended.close();

  const Hdf5File file = Hdf5File::open(folder / "sample.h5");

  EXPECT_EQ(file.read_doubles("/more"), doubles);
  EXPECT_EQ(file.read_integers("/integers"), integers);
}

TEST(Hdf5File, ChangesNothingOnTheDiskUntilItIsClosed) {
  const test::Scratch folder;
  write_sample(folder / "sample.h5");
  const std::string before = test::read_bytes(folder / "sample.h5");

  Hdf5File::append(folder / "sample.h5").write("/more", doubles);
  Hdf5File::create(folder / "sample.h5").write("/other", doubles);

  EXPECT_EQ(test::read_bytes(folder / "sample.h5"), before);
}

TEST(Hdf5File, FollowsALinkToAnotherFileRelativeToItsOwnFolder) {
  const test::Scratch folder;
  std::filesystem::create_directory(folder / "frames");
  write_sample(folder / "frames/one.h5");
  Hdf5File index = Hdf5File::create(folder / "run.h5");
  index.link_external("/one", "frames/one.h5", "/group");
  index.link_external("/absent", "frames/two.h5", "/group");
  index.close();

  const Hdf5File file = Hdf5File::open(folder / "run.h5");

  EXPECT_EQ(file.read_doubles("/one/matrix"), doubles);
  EXPECT_FALSE(file.contains("/absent"));
}

TEST(Hdf5File, KeepsTheFileOfBeforeOnAFullDisk) {
  const test::Scratch folder;
  const std::filesystem::path path = folder / "sample.h5";
  write_sample(path);
  const std::string before = test::read_bytes(path);
  const std::string message = path.string() + ": cannot be written: File too large";

  for (const rlim_t free : {0, 100, 2048, 80'000}) {  // cut in the header, between the parts, in the data
    EXPECT_TRUE(test::holds_on_full_disk(free, [&] {
      return test::throws<RunError>(
          [&] {
            Hdf5File file = Hdf5File::create(path);
            file.write("/large", std::vector<double>(10'000));
            file.close();
          },
          message.c_str());
    })) << free;
    EXPECT_EQ(test::read_bytes(path), before);
  }
}

TEST(Hdf5File, RefusesAFileCutOffAnywhere) {
  const test::Scratch folder;
  write_sample(folder / "whole.h5");
  const std::string bytes = test::read_bytes(folder / "whole.h5");
  const std::string path = (folder / "cut.h5").string();
  const std::string not_hdf5 = path + ": not an HDF5 file";
  const std::string damaged = path + ": a damaged HDF5 file, perhaps cut off";
  constexpr std::size_t signature = 8;  // bytes by which an HDF5 file is known

  for (std::size_t size = 0; size < bytes.size(); size += size < 100 ? 1 : 97) {
    replace_file(path, std::string_view{bytes}.substr(0, size));
    EXPECT_EQ(message_of<InputError>([&] { std::ignore = Hdf5File::open(path); }),
              size < signature ? not_hdf5 : damaged)
        << size << " bytes";
  }
}

TEST(Hdf5File, NamesTheFileThatItCannotOpen) {
  const test::Scratch folder;
  const std::string absent = (folder / "absent.h5").string();
  const std::string text = (folder / "text.h5").string();
  replace_file(text, "not at all HDF5, though longer than its signature");

  EXPECT_EQ(message_of<InputError>([&] { std::ignore = Hdf5File::open(absent); }),
            absent + ": cannot be read: No such file or directory");
  EXPECT_EQ(message_of<InputError>([&] { std::ignore = Hdf5File::append(text); }),
            text + ": not an HDF5 file");
  EXPECT_EQ(message_of<InputError>([&] { std::ignore = Hdf5File::open(folder.path()); }),
            folder.path().string() + ": cannot be read: Is a directory");
}

TEST(Hdf5File, NamesTheObjectThatItCannotRead) {
  const test::Scratch folder;
  const std::string path = (folder / "sample.h5").string();
  write_sample(path);
  const Hdf5File file = Hdf5File::open(path);

  EXPECT_EQ(message_of<InputError>([&] { std::ignore = file.read_doubles("/absent"); }),
            path + ": has no dataset '/absent'");
  EXPECT_EQ(message_of<InputError>([&] { std::ignore = file.read_doubles("/integers"); }),
            path + ": '/integers': expected floating-point numbers, found integers");
  EXPECT_EQ(message_of<InputError>([&] { std::ignore = file.read_integers("/group/matrix"); }),
            path + ": '/group/matrix': expected integers, found floating-point numbers");
  EXPECT_EQ(message_of<InputError>([&] { std::ignore = file.read_text("/integers"); }),
            path + ": '/integers': expected text, found integers");
  EXPECT_EQ(message_of<InputError>([&] { std::ignore = file.double_attribute("/", "absent"); }),
            path + ": has no attribute 'absent' of '/'");
  EXPECT_EQ(message_of<InputError>([&] { std::ignore = file.integer_attribute("/", "time"); }),
            path + ": attribute 'time' of '/': expected integers, found floating-point numbers");
  EXPECT_EQ(message_of<InputError>([&] { std::ignore = file.children("/absent"); }),
            path + ": has no group '/absent'");
}

TEST(Hdf5File, NamesTheObjectThatItCannotWrite) {
  const test::Scratch folder;
  const std::string path = (folder / "sample.h5").string();
  Hdf5File file = Hdf5File::create(path);
  file.write("/twice", doubles);

  EXPECT_EQ(message_of<RunError>([&] { file.write("/twice", doubles); }), path + ": cannot write '/twice'");
  EXPECT_EQ(message_of<RunError>([&] { file.write("/no/group", integers); }),
            path + ": cannot write '/no/group'");
  EXPECT_EQ(message_of<RunError>([&] { file.create_group("/twice"); }),
            path + ": cannot make the group '/twice'");
  EXPECT_EQ(message_of<RunError>([&] { file.write_attribute("/absent", "unit", 1.0); }),
            path + ": cannot write attribute 'unit' of '/absent'");
}

TEST(Hdf5File, PrintsNothing) {
  const test::Scratch folder;
  write_sample(folder / "sample.h5");

  testing::internal::CaptureStderr();
  EXPECT_THROW(std::ignore = Hdf5File::open(folder / "absent.h5"), InputError);
  EXPECT_THROW(std::ignore = Hdf5File::open(folder / "sample.h5").shape("/absent"), InputError);

  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace scree::io
