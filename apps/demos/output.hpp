#pragma once

#include <scree/error.hpp>
#include <scree/lattice.hpp>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <vector>

/// What the demos leave for plot_demos.py to draw.
namespace demo {

/// A quantity at each of some points.
struct Column {
  std::string name;
  std::vector<double> values;
};

/// The folder that the program was told to write into; the current one if it was told nothing.
[[nodiscard]] inline std::filesystem::path folder_from(int argc, char** argv) {
  return argc > 1 ? argv[1] : ".";
}

/// A file to write numbers to.  @throws scree::InputError if it cannot be opened.
[[nodiscard]] inline std::ofstream open(const std::filesystem::path& file) {
  std::ofstream out{file};
  scree::require(out.is_open(), file.string() + ": cannot be written");
  out.precision(9);
  return out;
}

/// Writes columns of one length side by side, below their names.
inline void write_table(const std::filesystem::path& file, const std::vector<Column>& columns) {
  std::ofstream out = open(file);
  for (std::size_t k = 0; k < columns.size(); ++k) out << (k == 0 ? "" : ",") << columns[k].name;
  for (std::size_t row = 0; row < columns.front().values.size(); ++row) {
    for (std::size_t k = 0; k < columns.size(); ++k) out << (k == 0 ? "\n" : ",") << columns[k].values[row];
  }
  out << "\n";
}

/// Writes one component of a field on cells of a plane: below the limits of both axes, a row of cells per
/// line, the lowest first.
/// @param u num_sites x num_components, component fastest
inline void write_plane(const std::filesystem::path& file, const scree::Lattice<2>& cells,
                        std::span<const double> u, std::size_t num_components = 1,
                        std::size_t component = 0) {
  std::ofstream out = open(file);
  const scree::Vector<2> low = cells.first - cells.spacing / 2;
  for (int axis = 0; axis < 2; ++axis) {
    const auto extent =
        static_cast<double>(cells.count[static_cast<std::size_t>(axis)]) * cells.spacing[axis];
    out << (axis == 0 ? "# " : " ") << low[axis] << " " << low[axis] + extent;
  }
  for (std::size_t site = 0; site * num_components < u.size(); ++site) {
    out << (site % static_cast<std::size_t>(cells.count[0]) == 0 ? "\n" : ",")
        << u[site * num_components + component];
  }
  out << "\n";
}

}  // namespace demo
