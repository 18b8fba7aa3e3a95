#include "child.hpp"
#include "sample_frame.hpp"
#include "scratch.hpp"

#include <scree/error.hpp>
#include <scree/io/column_writer.hpp>
#include <scree/io/frame_reader.hpp>
#include <scree/io/hdf5/file.hpp>
#include <scree/io/xdmf.hpp>

#include <algorithm>
#include <utility>

namespace scree::io {
namespace {

using test::message_of;
using test::SampleFrame;

void write_frames(FrameWriter& writer, std::int64_t first, std::int64_t end) {
  for (std::int64_t step = first; step < end; ++step) writer.write(SampleFrame{step, 2}.frame());
}

std::vector<std::int64_t> steps_in(const std::filesystem::path& directory) {
  std::vector<std::int64_t> steps;
  const FrameReader reader{directory};
  for (const StoredFrame& frame : reader.frames()) steps.push_back(frame.step);
  return steps;
}

TEST(FrameWriter, MakesOneTreeOutOfItsFrames) {
  const test::Scratch folder;
  FrameWriter writer = FrameWriter::create(folder / "out");
  write_frames(writer, 0, 2);

  const Hdf5File run = Hdf5File::open(folder / "out/run.h5");

  EXPECT_EQ(run.children("/frames"), (std::vector<std::string>{"000000", "000001"}));
  EXPECT_EQ(run.double_attribute("/frames/000001", "time"), 0.5);
  EXPECT_EQ(run.integer_attribute("/frames/000001", "step"), 1);
  EXPECT_EQ(run.read_doubles("/frames/000001/volume"), (std::vector<double>{1, 1.125}));
  EXPECT_EQ(run.text_attribute("/frames/000001/volume", "unit"), "m^3");
  EXPECT_EQ(run.text_attribute("/frames/000001/volume", "symbol"), "V");
}

TEST(FrameWriter, DescribesToViewersWhatItKeeps) {
  const test::Scratch folder;
  FrameWriter writer = FrameWriter::create(folder.path());
  write_frames(writer, 0, 3);

  const FrameReader reader{folder.path()};

  EXPECT_TRUE(std::ranges::equal(reader.frames(), writer.frames()));
  EXPECT_EQ(test::read_bytes(folder / "run.xdmf"), to_xdmf(writer.frames()));
}

TEST(FrameWriter, RemovesTheFramesOfAnOlderRun) {
  const test::Scratch folder;
  FrameWriter older = FrameWriter::create(folder.path());
  write_frames(older, 0, 3);

  FrameWriter writer = FrameWriter::create(folder.path());
  write_frames(writer, 5, 6);

  EXPECT_EQ(steps_in(folder.path()), (std::vector<std::int64_t>{5}));
  EXPECT_FALSE(std::filesystem::exists(folder / "frames/000001.h5"));
}

TEST(FrameWriter, ResumesAfterTheStepOfACheckpointAsIfUnbroken) {
  const test::Scratch folder;
  FrameWriter unbroken = FrameWriter::create(folder / "unbroken");
  write_frames(unbroken, 0, 6);
  FrameWriter broken = FrameWriter::create(folder / "broken");
  write_frames(broken, 0, 5);

  FrameWriter resumed = FrameWriter::resume(folder / "broken", 2);
  EXPECT_EQ(steps_in(folder / "broken"), (std::vector<std::int64_t>{0, 1, 2}));
  write_frames(resumed, 3, 6);

  for (const char* const name : {"run.h5", "run.xdmf", "frames/000000.h5", "frames/000005.h5"}) {
    EXPECT_EQ(test::read_bytes(folder / "broken" / name), test::read_bytes(folder / "unbroken" / name));
  }
}

TEST(FrameWriter, KeepsAllEarlierFramesOnAFullDiskAndGoesOnWhenThereIsRoom) {
  const test::Scratch folder;
  FrameWriter writer = FrameWriter::create(folder.path());
  write_frames(writer, 0, 2);
  const SampleFrame large{2, 1000};
  const std::string message = (folder / "frames/000002.h5").string() + ": cannot be written: File too large";

  EXPECT_TRUE(test::holds_on_full_disk(20'000, [&] {  // a frame of 1000 points takes 150 kB
    return test::throws<RunError>([&] { writer.write(large.frame()); }, message.c_str());
  }));

  EXPECT_EQ(steps_in(folder.path()), (std::vector<std::int64_t>{0, 1}));
  write_frames(writer, 2, 3);
  EXPECT_EQ(steps_in(folder.path()), (std::vector<std::int64_t>{0, 1, 2}));
}

TEST(FrameWriter, LosesNoFrameToARestartOnAFullDisk) {
  const test::Scratch folder;
  FrameWriter writer = FrameWriter::create(folder.path());
  write_frames(writer, 0, 3);
  const std::string message = (folder / "run.h5").string() + ": cannot be written: File too large";

  EXPECT_TRUE(test::holds_on_full_disk(0, [&] {
    return test::throws<RunError>([&] { std::ignore = FrameWriter::resume(folder.path(), 1); },
                                  message.c_str());
  }));

  EXPECT_EQ(steps_in(folder.path()), (std::vector<std::int64_t>{0, 1, 2}));
}

TEST(FrameWriter, RefusesADirectoryItCannotMake) {
  EXPECT_EQ(message_of<RunError>([] { std::ignore = FrameWriter::create("/proc/scree"); }),
            "/proc/scree: cannot be written: No such file or directory");
}

class BadFrame : public testing::Test {
 protected:
  std::string message() {
    FrameWriter writer = FrameWriter::create(folder_.path());
    return message_of<InputError>([&] { writer.write(frame_); });
  }

  test::Scratch folder_;
  SampleFrame sample_{0, 2};
  Frame frame_ = sample_.frame();
};

TEST_F(BadFrame, HasTooFewValues) {
  frame_.columns[3].values = frame_.columns[3].values.first(1);
  EXPECT_EQ(message(), "column 'volume': has 1 value, expected 2 points x 1 component");
}

TEST_F(BadFrame, HasAVectorOfFourComponents) {
  frame_.columns[0].num_components = 4;
  EXPECT_EQ(message(), "column 'velocity': a vector does not have 4 components");
}

TEST_F(BadFrame, HasTwoComponentsAlongOneAxis) {
  frame_.columns[0].axes = {1, 1, 2};
  EXPECT_EQ(message(), "column 'velocity': each component of a vector has one axis, 0, 1 or 2");
}

TEST_F(BadFrame, HasATensorOfSixComponents) {
  frame_.columns[2].num_components = 6;
  EXPECT_EQ(message(), "column 'stress': a tensor does not have 6 components");
}

TEST_F(BadFrame, HasTwoColumnsOfOneName) {
  frame_.columns[3].quantity.name = "velocity";
  EXPECT_EQ(message(), "column 'velocity': given twice");
}

TEST_F(BadFrame, HasNoPosition) {
  frame_.position.quantity.name = "place";
  EXPECT_EQ(message(), "column 'place': the points are placed by a vector named 'position'");
}

TEST_F(BadFrame, HasANameThatIsAPath) {
  frame_.columns[3].quantity.name = "a/b";
  EXPECT_EQ(message(), "column 'a/b': a name is not empty and has no '/' or '.'");
}

}  // namespace
}  // namespace scree::io
