#include "scree/run/run_path.hpp"

#include <scree/error.hpp>
#include <scree/io/replace_file.hpp>
#include <scree/rheology/columns.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>
#include <variant>

namespace scree::app {

namespace {

using rheology::PathPoint;
using rheology::PathRecord;

/// A column of the table of a path.
struct Column {
  std::string name;
  std::string_view unit;
  std::function<double(const PathRecord&)> value;
};

/// The components of a tensor, a column each.
void add_components(std::vector<Column>& columns, std::string_view name, std::string_view unit,
                    const std::function<const Tensor<double>&(const PathRecord&)>& tensor) {
  for (const rheology::Component& component : rheology::symmetric_components) {
    columns.push_back({fmt::format("{}_{}", name, component.name), unit, [=](const PathRecord& record) {
                         return tensor(record)(component.row, component.column);
                       }});
  }
}

void add_velocity_gradient(std::vector<Column>& columns) {
  constexpr std::string_view axes = "xyz";
  for (std::size_t i = 0; i < 9; ++i) {
    columns.push_back({fmt::format("velocity_gradient_{}{}", axes[i / 3], axes[i % 3]), "1/s",
                       [i](const PathRecord& record) { return record.velocity_gradient.components[i]; }});
  }
}

void add_state(std::vector<Column>& columns, const PathPoint& point) {
  for (std::size_t i = 0; i < point.state_columns().size(); ++i) {
    const StateColumn& state = point.state_columns()[i];
    columns.push_back(
        {std::string{state.name}, state.unit, [i](const PathRecord& record) { return record.state[i]; }});
  }
}

[[nodiscard]] std::vector<Column> columns_of(const PathPoint& point) {
  std::vector<Column> columns;
  columns.push_back({"time", "s", [](const PathRecord& r) { return r.at.time; }});
  columns.push_back({"stage", "-", [](const PathRecord& r) { return static_cast<double>(r.stage + 1); }});
  add_components(
      columns, "strain", "-", [](const PathRecord& r) -> auto& { return r.at.strain; });
  columns.push_back({"volumetric_strain", "-", [](const PathRecord& r) { return r.volumetric_strain; }});
  columns.push_back({"density", "kg/m^3", [](const PathRecord& r) { return r.at.density; }});
  add_components(
      columns, "stress", "Pa", [](const PathRecord& r) -> auto& { return r.at.stress; });
  columns.push_back({"pressure", "Pa", [](const PathRecord& r) { return r.pressure; }});
  columns.push_back({"deviatoric_stress", "Pa", [](const PathRecord& r) { return r.deviatoric_stress; }});
  columns.push_back({"lode_angle", "rad", [](const PathRecord& r) { return r.lode_angle; }});
  add_velocity_gradient(columns);
  columns.push_back({"shear_rate", "1/s", [](const PathRecord& r) { return r.shear_rate; }});
  columns.push_back({"inertial_number", "-", [](const PathRecord& r) { return r.inertial_number; }});
  columns.push_back({"dissipation", "W/m^3", [](const PathRecord& r) { return r.dissipation; }});
  columns.push_back({"stability_number", "-", [](const PathRecord& r) { return r.stability_number; }});
  columns.push_back(
      {"iterations", "-", [](const PathRecord& r) { return static_cast<double>(r.iterations); }});
  add_state(columns, point);
  return columns;
}

/// An aggregate of numbers, one for each column that describes it.
template <class Aggregate, class Columns>
[[nodiscard]] Aggregate from_numbers(const Columns& columns, const std::vector<double>& numbers) {
  std::size_t next = 0;
  return rheology::made_of<Aggregate>(columns, [&](const auto& /*column*/) { return numbers.at(next++); });
}

}  // namespace

std::unique_ptr<PathPoint> start_of(const PathFile& file) {
  return std::visit(
      [&](const auto& law) -> std::unique_ptr<PathPoint> {
        using Law = std::decay_t<decltype(law)>;
        using Point = rheology::PathPointOf<Law>;
        const auto input = from_numbers<typename Point::Input>(Law::inputs, file.inputs);
        const auto state = from_numbers<typename Point::State>(Law::states, file.state);
        const double density =
            file.pressure ? density_at_pressure(Point{law, law.density, input, state}, *file.pressure)
                          : file.density;
        return std::make_unique<Point>(law, density, input, state);
      },
      file.law);
}

std::string csv_of(const PathPoint& point, std::span<const PathRecord> records) {
  std::vector<Column> columns = columns_of(point);
  std::erase_if(columns, [&](const Column& column) {
    return std::ranges::all_of(records, [&](const PathRecord& r) { return std::isnan(column.value(r)); });
  });
  std::string csv;
  const auto add = [&](const auto& text_of) {
    for (const Column& column : columns) {
      csv += text_of(column);
      csv += &column == &columns.back() ? '\n' : ',';
    }
  };
  add([](const Column& column) { return fmt::format("{} [{}]", column.name, column.unit); });
  for (const PathRecord& record : records) {
    add([&](const Column& column) { return fmt::format("{}", column.value(record)); });
  }
  return csv;
}

void run_path(const PathFile& file, const std::filesystem::path& directory) {
  const std::unique_ptr<PathPoint> point = start_of(file);
  std::filesystem::create_directories(directory);
  std::vector<PathRecord> records;
  const auto write = [&] { io::replace_file(directory / "path.csv", csv_of(*point, records)); };
  try {
    rheology::drive(*point, file.stages, {}, records);
  } catch (const RunError&) {
    write();
    throw;
  }
  write();
}

}  // namespace scree::app
