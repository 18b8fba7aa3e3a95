#include "sample_frame.hpp"
#include "scratch.hpp"

#include <scree/error.hpp>
#include <scree/io/column_writer.hpp>
#include <scree/io/frame_reader.hpp>

#include <limits>
#include <utility>

namespace scree::io {
namespace {

using test::message_of;
using test::SampleFrame;

void write_frames(const std::filesystem::path& directory, std::int64_t count) {
  FrameWriter writer = FrameWriter::create(directory);
  for (std::int64_t step = 0; step < count; ++step) writer.write(SampleFrame{step, 2}.frame());
}

TEST(FrameReader, GivesBackEveryColumnVectorsInSpace) {
  const test::Scratch folder;
  write_frames(folder.path(), 2);
  const SampleFrame sample{1, 2};

  const FrameReader reader{folder.path()};

  const StoredFrame& frame = reader.frames()[1];
  EXPECT_EQ(frame.time, 0.5);
  EXPECT_EQ(frame.step, 1);
  EXPECT_EQ(frame.num_points, 2);
  EXPECT_EQ(reader.read(frame, "position"), (std::vector<double>{0, 1, 0, 0, 1.125, 0}));
  EXPECT_EQ(reader.read(frame, "velocity"), (std::vector<double>{2, -1, 0, 2.25, -1.125, 0}));
  EXPECT_EQ(reader.read(frame, "fraction"), sample.fractions);
  EXPECT_EQ(reader.read(frame, "stress"), sample.stresses);
  EXPECT_EQ(reader.read(frame, "volume"), sample.volumes);
}

TEST(FrameReader, DescribesTheColumnsAsTheyWereWritten) {
  const test::Scratch folder;
  write_frames(folder.path(), 1);

  const FrameReader reader{folder.path()};

  const std::vector<StoredColumn> expected{
      {.quantity = {"fraction", "phi", "-"}, .kind = ColumnKind::classes, .num_components = 2},
      {.quantity = {"position", "x", "m"}, .kind = ColumnKind::vector, .num_components = 3},
      {.quantity = {"stress", "sigma", "Pa"}, .kind = ColumnKind::tensor, .num_components = 9},
      {.quantity = {"velocity", "v", "m/s"}, .kind = ColumnKind::vector, .num_components = 3},
      {.quantity = {"volume", "V", "m^3"}}};
  EXPECT_EQ(reader.frames()[0].columns, expected);
}

TEST(FrameReader, FindsTheFrameNearestInTimeTheEarlierOfTwoAsNear) {
  const test::Scratch folder;
  write_frames(folder.path(), 3);  // at 0, 0.5 and 1 s

  const FrameReader reader{folder.path()};

  EXPECT_EQ(reader.nearest(-7).step, 0);
  EXPECT_EQ(reader.nearest(0.3).step, 1);
  EXPECT_EQ(reader.nearest(0.25).step, 0);
  EXPECT_EQ(reader.nearest(std::numeric_limits<double>::infinity()).step, 0);  // all as far
  EXPECT_EQ(reader.nearest(99).step, 2);
  EXPECT_EQ(
      message_of<InputError>([&] { std::ignore = reader.nearest(std::numeric_limits<double>::quiet_NaN()); }),
      "a time to look for must be a number");
}

TEST(FrameReader, NamesWhatItCannotFind) {
  const test::Scratch folder;
  const std::string run = (folder / "run.h5").string();

  EXPECT_EQ(message_of<InputError>([&] { const FrameReader reader{folder.path()}; }),
            run + ": cannot be read: No such file or directory");
  write_frames(folder.path(), 0);
  EXPECT_EQ(message_of<InputError>([&] { std::ignore = FrameReader{folder.path()}.nearest(0); }),
            run + ": holds no frames yet");
  write_frames(folder.path(), 1);
  const FrameReader reader{folder.path()};
  EXPECT_EQ(message_of<InputError>([&] { std::ignore = reader.read(reader.frames()[0], "pressure"); }),
            (folder / "frames/000000.h5").string() +
                ": has no column 'pressure', it has fraction, position, stress, velocity, volume");
}

}  // namespace
}  // namespace scree::io
