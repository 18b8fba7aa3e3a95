#include "sample_frame.hpp"
#include "scratch.hpp"

#include <scree/error.hpp>
#include <scree/io/checkpoint.hpp>
#include <scree/io/column_writer.hpp>
#include <scree/io/frame_reader.hpp>
#include <scree/io/hdf5/file.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <random>
#include <thread>

namespace scree::io {
namespace {

using test::SampleFrame;

constexpr std::size_t num_points = 200;
constexpr std::int64_t version = 1;

/// A run that never ends: frames and checkpoints in turn, each reported through `report` when it is done.
[[noreturn]] void write_forever(const std::filesystem::path& directory, int report) {
  FrameWriter writer = FrameWriter::create(directory);
  for (std::int64_t step = 0;; ++step) {
    const SampleFrame sample{step, num_points};
    writer.write(sample.frame());
    CheckpointWriter checkpoint{directory / "checkpoint.h5", version};
    checkpoint.add("step", step);
    checkpoint.add("volume", sample.volumes);
    checkpoint.commit();
    if (::write(report, &step, sizeof step) != sizeof step) ::_exit(EXIT_FAILURE);
  }
}

/// Starts the endless run, kills it after its first step and `delay` more, and
/// @return the last step that it reported as done.
std::int64_t last_step_of_killed_run(const std::filesystem::path& directory,
                                     std::chrono::microseconds delay) {
  std::array<int, 2> pipe{};
  if (::pipe(pipe.data()) != 0) throw RunError{"no pipe"};
  const pid_t child = ::fork();
  if (child == 0) write_forever(directory, pipe[1]);
  ::close(pipe[1]);
  std::int64_t step = -1;
  const bool has_begun = ::read(pipe[0], &step, sizeof step) == sizeof step;
  std::this_thread::sleep_for(delay);
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  while (has_begun && ::read(pipe[0], &step, sizeof step) == sizeof step) continue;
  ::close(pipe[0]);
  return step;
}

void expect_readable(const std::filesystem::path& directory, std::int64_t last_step) {
  const FrameReader reader{directory};
  ASSERT_GT(std::ssize(reader.frames()), last_step);
  for (const StoredFrame& frame : reader.frames()) {
    EXPECT_EQ(reader.read(frame, "stress"), (SampleFrame{frame.step, num_points}.stresses));
  }
  const Hdf5File run = Hdf5File::open(directory / "run.h5");
  for (const std::string& name : run.children("/frames"))
    EXPECT_TRUE(run.contains("/frames/" + name + "/stress"));
  const Checkpoint checkpoint = read_checkpoint(directory / "checkpoint.h5", version);
  EXPECT_GE(checkpoint.integer("step"), last_step);
  EXPECT_EQ(checkpoint.doubles("volume", static_cast<Index>(num_points)),
            (SampleFrame{checkpoint.integer("step"), num_points}.volumes));
}

TEST(KilledRun, LeavesEveryFrameAndTheLastCheckpointReadable) {
  constexpr int num_kills = 40;
  std::mt19937 random{20240607};
  std::uniform_int_distribution<int> microseconds{0, 60'000};  // some twenty steps

  for (int kill = 0; kill < num_kills; ++kill) {
    const test::Scratch folder;
    const std::chrono::microseconds delay{microseconds(random)};

    const std::int64_t last_step = last_step_of_killed_run(folder.path(), delay);

    ASSERT_GE(last_step, 0);
    SCOPED_TRACE("killed after " + std::to_string(delay.count()) + " us");
    expect_readable(folder.path(), last_step);
  }
}

}  // namespace
}  // namespace scree::io
