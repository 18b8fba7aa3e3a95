#include "stored_frame.hpp"

#include <scree/error.hpp>
#include <scree/io/column_writer.hpp>
#include <scree/io/frame_reader.hpp>
#include <scree/io/hdf5/file.hpp>
#include <scree/io/replace_file.hpp>
#include <scree/io/xdmf.hpp>

#include <algorithm>
#include <set>
#include <system_error>
#include <utility>

namespace scree::io {
namespace {

std::string frame_name(std::size_t number) {
  constexpr std::size_t num_digits = 6;
  const std::string digits = std::to_string(number);
  return std::string(num_digits - std::min(num_digits, digits.size()), '0') + digits;
}

std::string count(Index number, const std::string& thing) {
  return std::to_string(number) + " " + thing + (number == 1 ? "" : "s");
}

bool has_right_components(const Column& column) {
  constexpr Index num_axes = 3;
  switch (column.kind) {
    case ColumnKind::scalar:
      return column.num_components == 1;
    case ColumnKind::vector:
      return 1 <= column.num_components && column.num_components <= num_axes;
    case ColumnKind::tensor:
      return column.num_components == num_axes * num_axes;
    case ColumnKind::classes:
      return column.num_components >= 1;
  }
  return false;
}

/// Whether each component of a vector has an axis of its own.
bool has_right_axes(const Column& column) {
  std::set<int> axes;
  for (std::size_t i = 0; i < static_cast<std::size_t>(column.num_components); ++i) {
    const int axis = column.axes[i];
    if (axis < 0 || axis > 2 || !axes.insert(axis).second) return false;
  }
  return true;
}

/// @throws InputError if the components of the column are not those of its kind.
void require_components(const Column& column) {
  require(has_right_components(column), "column '" + column.quantity.name + "': a " +
                                            detail::to_name(column.kind) + " does not have " +
                                            count(column.num_components, "component"));
  require(column.kind != ColumnKind::vector || has_right_axes(column),
          "column '" + column.quantity.name + "': each component of a vector has one axis, 0, 1 or 2");
}

/// @throws InputError if the column is not one that can be stored.
StoredColumn to_stored(const Column& column, Index num_points) {
  const std::string& name = column.quantity.name;
  require(!name.empty() && name.find_first_of("/.") == std::string::npos,
          "column '" + name + "': a name is not empty and has no '/' or '.'");
  require_components(column);
  require(std::ssize(column.values) == num_points * column.num_components,
          "column '" + name + "': has " + count(std::ssize(column.values), "value") + ", expected " +
              count(num_points, "point") + " x " + count(column.num_components, "component"));
  return {.quantity = column.quantity,
          .kind = column.kind,
          .num_components = column.kind == ColumnKind::vector ? 3 : column.num_components};
}

StoredFrame to_stored(const Frame& frame, std::size_t number) {
  const Column& position = frame.position;
  require(position.quantity.name == "position" && position.kind == ColumnKind::vector,
          "column '" + position.quantity.name + "': the points are placed by a vector named 'position'");
  require_components(position);
  const Index num_points = std::ssize(position.values) / position.num_components;
  StoredFrame stored{
      .name = frame_name(number), .time = frame.time, .step = frame.step, .num_points = num_points};
  stored.columns.push_back(to_stored(position, num_points));
  for (const Column& column : frame.columns) stored.columns.push_back(to_stored(column, num_points));
  const auto name = [](const StoredColumn& column) -> const std::string& { return column.quantity.name; };
  std::ranges::sort(stored.columns, {}, name);
  const auto twice = std::ranges::adjacent_find(stored.columns, {}, name);
  require(twice == stored.columns.end(),
          "column '" + (twice == stored.columns.end() ? "" : name(*twice)) + "': given twice");
  return stored;
}

/// Clears the folder of frames of all that no index names any more.
void remove_unlisted(const std::filesystem::path& directory, std::span<const StoredFrame> frames) {
  std::set<std::filesystem::path> listed;
  for (const StoredFrame& frame : frames) listed.insert(directory / frame.file());
  for (const auto& entry : std::filesystem::directory_iterator{directory / "frames"}) {
    const std::filesystem::path& path = entry.path();
    const bool is_ours = path.extension() == ".h5" || path.extension() == ".partial";
    if (is_ours && !listed.contains(path)) std::filesystem::remove(path);
  }
}

}  // namespace

FrameWriter::FrameWriter(std::filesystem::path directory, std::vector<StoredFrame> frames)
    : directory_{std::move(directory)}, frames_{std::move(frames)} {
  try {
    std::filesystem::create_directories(directory_ / "frames");
    write_index();
    remove_unlisted(directory_, frames_);
  } catch (const std::filesystem::filesystem_error& error) {
    throw RunError{directory_.string() + ": cannot be written: " + error.code().message()};
  }
}

FrameWriter FrameWriter::create(std::filesystem::path directory) {
  return {std::move(directory), {}};
}

FrameWriter FrameWriter::resume(std::filesystem::path directory, std::int64_t step) {
  const FrameReader earlier{directory};
  std::vector<StoredFrame> kept;
  std::ranges::copy_if(earlier.frames(), std::back_inserter(kept),
                       [step](const StoredFrame& frame) { return frame.step <= step; });
  return {std::move(directory), std::move(kept)};
}

void FrameWriter::write(const Frame& frame) {
  const StoredFrame stored = to_stored(frame, frames_.size());
  detail::write_frame(directory_, stored, frame);
  frames_.push_back(stored);
  try {
    write_index();
  } catch (...) {
    frames_.pop_back();
    throw;
  }
}

void FrameWriter::write_index() const {
  Hdf5File run = Hdf5File::create(directory_ / "run.h5");
  run.create_group("/frames");
  for (const StoredFrame& frame : frames_) run.link_external("/frames/" + frame.name, frame.file(), "/");
  run.close(Durability::kill);
  replace_file(directory_ / "run.xdmf", to_xdmf(frames_), Durability::kill);
}

}  // namespace scree::io
