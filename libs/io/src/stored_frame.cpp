#include "stored_frame.hpp"

#include <scree/error.hpp>
#include <scree/io/hdf5/file.hpp>

#include <algorithm>

namespace scree::io::detail {
namespace {

constexpr std::array kinds{ColumnKind::scalar, ColumnKind::vector, ColumnKind::tensor, ColumnKind::classes};

/// The components of a vector, each on its axis of space: num_points x 3.
std::vector<double> in_space(const Column& column, Index num_points) {
  std::vector<double> result(static_cast<std::size_t>(3 * num_points), 0.0);
  const auto num_components = static_cast<std::size_t>(column.num_components);
  for (std::size_t i = 0; i < column.values.size(); ++i) {
    const auto axis = static_cast<std::size_t>(column.axes[i % num_components]);
    result[3 * (i / num_components) + axis] = column.values[i];
  }
  return result;
}

void write_column(Hdf5File& file, const Column& column, Index num_points) {
  const std::string object = "/" + column.quantity.name;
  if (column.kind == ColumnKind::vector) {
    file.write(object, in_space(column, num_points), {.num_rows = num_points, .num_columns = 3, .rank = 2});
  } else {
    const int rank = column.kind == ColumnKind::scalar ? 1 : 2;
    file.write(object, column.values,
               {.num_rows = num_points, .num_columns = column.num_components, .rank = rank});
  }
  file.write_attribute(object, "symbol", column.quantity.symbol);
  file.write_attribute(object, "unit", column.quantity.unit);
  file.write_attribute(object, "kind", to_name(column.kind));
}

ColumnKind kind_named(const std::string& name, const std::string& file) {
  const auto* const found = std::ranges::find(kinds, name, to_name);
  if (found == kinds.end()) throw InputError{file + ": a column of unknown kind '" + name + "'"};
  return *found;
}

}  // namespace

std::string to_name(ColumnKind kind) {
  switch (kind) {
    case ColumnKind::scalar:
      return "scalar";
    case ColumnKind::vector:
      return "vector";
    case ColumnKind::tensor:
      return "tensor";
    case ColumnKind::classes:
      return "classes";
  }
  return "";
}

void write_frame(const std::filesystem::path& directory, const StoredFrame& stored, const Frame& frame) {
  Hdf5File file = Hdf5File::create(directory / stored.file());
  file.write_attribute("/", "time", frame.time);
  file.write_attribute("/", "step", frame.step);
  write_column(file, frame.position, stored.num_points);
  for (const Column& column : frame.columns) write_column(file, column, stored.num_points);
  file.close(Durability::kill);
}

StoredFrame read_stored_frame(const std::filesystem::path& directory, const std::string& name) {
  StoredFrame frame{.name = name};
  const std::filesystem::path path = directory / frame.file();
  const Hdf5File file = Hdf5File::open(path);
  frame.time = file.double_attribute("/", "time");
  frame.step = file.integer_attribute("/", "step");
  frame.num_points = file.shape("/position").num_rows;
  for (const std::string& column : file.children("/")) {
    const std::string object = "/" + column;
    frame.columns.push_back({.quantity = {.name = column,
                                          .symbol = file.text_attribute(object, "symbol"),
                                          .unit = file.text_attribute(object, "unit")},
                             .kind = kind_named(file.text_attribute(object, "kind"), path.string()),
                             .num_components = file.shape(object).num_columns});
  }
  return frame;
}

}  // namespace scree::io::detail
