#pragma once

#include <scree/quantity.hpp>
#include <scree/tensor.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace scree::io {

/// What the components of a column are to each other, so that viewers draw it rightly.
enum class ColumnKind {
  scalar,   ///< one component
  vector,   ///< one to three components in space; three are stored, the missing ones 0
  tensor,   ///< nine components, 3x3, row by row
  classes,  ///< one number for each of several classes; each is a scalar to a viewer
};

/// One quantity at every point, as it is handed to FrameWriter.
struct Column {
  Quantity quantity{};
  ColumnKind kind = ColumnKind::scalar;
  Index num_components = 1;
  std::span<const double> values{};  ///< num_points x num_components, component fastest
  /// The axis of space (0, 1, 2) that each component of a vector lies along: {1} for a column of height y.
  std::array<int, 3> axes{0, 1, 2};
};

/// Everything to be stored of one instant.
struct Frame {
  double time = 0;  ///< [s]
  std::int64_t step = 0;
  Column position{};  ///< a vector; says how many points there are
  std::vector<Column> columns{};
};

/// A column as it lies in a file: `num_points` or `num_points x num_components` doubles.
struct StoredColumn {
  Quantity quantity{};
  ColumnKind kind = ColumnKind::scalar;
  Index num_components = 1;

  friend bool operator==(const StoredColumn&, const StoredColumn&) = default;
};

/// A frame as it lies in an output directory.
struct StoredFrame {
  std::string name{};  ///< six digits or more; the frame is the group /frames/\<name\> of run.h5
  double time = 0;     ///< [s]
  std::int64_t step = 0;
  Index num_points = 0;
  std::vector<StoredColumn> columns{};  ///< by name, position among them

  /// The file that holds the frame, relative to the output directory: "frames/<name>.h5".
  [[nodiscard]] std::string file() const { return std::string{"frames/"}.append(name).append(".h5"); }

  friend bool operator==(const StoredFrame&, const StoredFrame&) = default;
};

}  // namespace scree::io
