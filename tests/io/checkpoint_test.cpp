#include "child.hpp"
#include "scratch.hpp"

#include <scree/error.hpp>
#include <scree/io/checkpoint.hpp>
#include <scree/io/replace_file.hpp>

#include <cmath>
#include <utility>
#include <vector>

namespace scree::io {
namespace {

using test::message_of;

constexpr std::int64_t version = 3;
const std::vector<double> positions{0.1, 1.0 / 3, 5e-324, -0.0};
const std::vector<std::int64_t> block_starts{0, 2, 4};

void write_checkpoint(const std::filesystem::path& path, std::int64_t step) {
  CheckpointWriter writer{path, version};
  writer.add("position", positions);
  writer.add("block_starts", block_starts);
  writer.add("time", 0.1);
  writer.add("step", step);
  writer.add_text("scene", "[mesh]\ncells = 51\n");
  writer.commit();
}

TEST(Checkpoint, GivesBackEveryBit) {
  const test::Scratch folder;
  write_checkpoint(folder / "checkpoint.h5", 7);

  const Checkpoint checkpoint = read_checkpoint(folder / "checkpoint.h5", version);

  EXPECT_EQ(checkpoint.length("position"), 4);
  EXPECT_EQ(checkpoint.doubles("position", 4), positions);
  EXPECT_TRUE(std::signbit(checkpoint.doubles("position", 4)[3]));
  EXPECT_EQ(checkpoint.integers("block_starts", 3), block_starts);
  EXPECT_EQ(checkpoint.number("time"), 0.1);
  EXPECT_EQ(checkpoint.integer("step"), 7);
  EXPECT_EQ(checkpoint.text("scene"), "[mesh]\ncells = 51\n");
  EXPECT_TRUE(checkpoint.contains("position"));
  EXPECT_FALSE(checkpoint.contains("velocity"));
}

TEST(Checkpoint, IsReplacedOnlyByCommit) {
  const test::Scratch folder;
  write_checkpoint(folder / "checkpoint.h5", 7);

  {
    CheckpointWriter dropped{folder / "checkpoint.h5", version};
    dropped.add("step", std::int64_t{8});
  }
  EXPECT_EQ(read_checkpoint(folder / "checkpoint.h5", version).integer("step"), 7);
  write_checkpoint(folder / "checkpoint.h5", 9);
  EXPECT_EQ(read_checkpoint(folder / "checkpoint.h5", version).integer("step"), 9);
}

TEST(Checkpoint, OfBeforeSurvivesAFullDisk) {
  const test::Scratch folder;
  const std::string path = (folder / "checkpoint.h5").string();
  write_checkpoint(path, 7);

  EXPECT_TRUE(test::holds_on_full_disk(1000, [&] {
    return test::throws<RunError>([&] { write_checkpoint(path, 8); },
                                  (path + ": cannot be written: File too large").c_str());
  }));

  EXPECT_EQ(read_checkpoint(path, version).integer("step"), 7);
}

TEST(Checkpoint, RefusesAFileThatIsAbsentCutOffOrSomethingElse) {
  const test::Scratch folder;
  const std::string path = (folder / "checkpoint.h5").string();
  const auto read = [&] { std::ignore = read_checkpoint(path, version); };

  EXPECT_EQ(message_of<InputError>(read), path + ": cannot be read: No such file or directory");
  replace_file(path, "time = 3\n");
  EXPECT_EQ(message_of<InputError>(read), path + ": not an HDF5 file");
  write_checkpoint(path, 7);
  std::filesystem::resize_file(path, std::filesystem::file_size(path) - 1);
  EXPECT_EQ(message_of<InputError>(read), path + ": a damaged HDF5 file, perhaps cut off");
  Hdf5File::create(path).close();
  EXPECT_EQ(message_of<InputError>(read), path + ": not a checkpoint of scree");
}

TEST(Checkpoint, RefusesAnotherVersion) {
  const test::Scratch folder;
  const std::string path = (folder / "checkpoint.h5").string();
  write_checkpoint(path, 7);

  EXPECT_EQ(message_of<InputError>([&] { std::ignore = read_checkpoint(path, version + 1); }),
            path + ": a checkpoint of version 3, this program reads version 4");
}

TEST(Checkpoint, NamesTheEntryThatDoesNotFit) {
  const test::Scratch folder;
  const std::string path = (folder / "checkpoint.h5").string();
  write_checkpoint(path, 7);
  const Checkpoint checkpoint = read_checkpoint(path, version);

  EXPECT_EQ(message_of<InputError>([&] { std::ignore = checkpoint.doubles("velocity", 4); }),
            path + ": has no dataset 'velocity'");
  EXPECT_EQ(message_of<InputError>([&] { std::ignore = checkpoint.doubles("position", 6); }),
            path + ": 'position': expected 6 values, found 4");
  EXPECT_EQ(message_of<InputError>([&] { std::ignore = checkpoint.integers("position", 4); }),
            path + ": 'position': expected integers, found floating-point numbers");
  EXPECT_EQ(message_of<InputError>([&] { std::ignore = checkpoint.number("dt"); }),
            path + ": has no attribute 'dt' of '/'");
}

}  // namespace
}  // namespace scree::io
