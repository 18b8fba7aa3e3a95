#pragma once

#include <scree/io/frame.hpp>

#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace scree::io {

/// Reads what FrameWriter wrote, also while a run is going on or after it was killed.
class FrameReader {
 public:
  /// @throws InputError if `directory` holds no readable run.h5, naming it.
  explicit FrameReader(std::filesystem::path directory);

  /// The frames, in order of time.
  [[nodiscard]] std::span<const StoredFrame> frames() const noexcept { return frames_; }

  /// The frame at the stored time nearest `time` [s], the earlier of two as near.
  /// @throws InputError if there are no frames, or `time` is NaN.
  [[nodiscard]] const StoredFrame& nearest(double time) const;

  /// The values of one column, `num_points x num_components`, component fastest, in its stored unit.
  /// @throws InputError naming the file and the columns it has, if `name` is not one of them.
  [[nodiscard]] std::vector<double> read(const StoredFrame& frame, std::string_view name) const;

 private:
  std::filesystem::path directory_;
  std::vector<StoredFrame> frames_;
};

}  // namespace scree::io
