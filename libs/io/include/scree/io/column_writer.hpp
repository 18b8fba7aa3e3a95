#pragma once

#include <scree/io/frame.hpp>

#include <filesystem>
#include <span>
#include <vector>

namespace scree::io {

/// Writes the columns of a run, instant by instant, so that a kill at any moment costs the frame being
/// written and no other.
///
/// A frame is a file of its own, `frames/000123.h5`, moved to its name when it is whole; `run.h5` holds one
/// external link per frame, /frames/000123, and `run.xdmf` describes them to viewers. These two are replaced
/// whole after each frame. (A cut of power may cost the frames of the last minute; a checkpoint it cannot.)
/// In a frame, /\<name\> is one dataset with the attributes `symbol`, `unit` and `kind`; `time` [s] and
/// `step` are attributes of the group.
class FrameWriter {
 public:
  /// Starts an output directory, made if needed. Frames of an older run in it are removed.
  /// @throws RunError if it cannot be written.
  [[nodiscard]] static FrameWriter create(std::filesystem::path directory);

  /// Goes on in the directory of an earlier run, after its frames up to and including `step`; later ones
  /// are removed.  @throws InputError if run.h5 or a frame cannot be read, RunError if not written.
  [[nodiscard]] static FrameWriter resume(std::filesystem::path directory, std::int64_t step);

  /// Writes one frame.
  /// @throws InputError if a column has the wrong number of values or components, or a name comes twice;
  /// RunError if it cannot be written (a full disk): all earlier frames are then still there.
  void write(const Frame& frame);

  /// The frames written so far, in order of time.
  [[nodiscard]] std::span<const StoredFrame> frames() const noexcept { return frames_; }

 private:
  FrameWriter(std::filesystem::path directory, std::vector<StoredFrame> frames);
  void write_index() const;

  std::filesystem::path directory_;
  std::vector<StoredFrame> frames_;
};

}  // namespace scree::io
