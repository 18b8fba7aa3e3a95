#pragma once

#include <scree/rheology/laws.hpp>
#include <scree/rheology/path/drive.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace scree::app {

/// A path of a material point as plain data, checked.
struct PathFile {
  std::string title;
  rheology::AnyLaw law;
  std::vector<double> inputs;      ///< a number per column that the law reads, in its unit
  std::vector<double> state;       ///< the law's memory at the start, a number per column, in its unit
  std::optional<double> pressure;  ///< of the point at rest [Pa]; if not given, its density is
  double density = 0;              ///< of the point at rest [kg/m^3]
  std::vector<rheology::Stage> stages;
};

/// Reads a path file.
/// @param overrides "table.key=value", each instead of what the file says
/// @throws InputError with all faults, one on a line: file, line, key, value and what was expected.
[[nodiscard]] PathFile read_path_file(const std::filesystem::path& path,
                                      const std::vector<std::string>& overrides = {});

/// The same of a text; `name` stands for the file in messages.
[[nodiscard]] PathFile parse_path_file(const std::string& text, const std::string& name,
                                       const std::vector<std::string>& overrides = {});

}  // namespace scree::app
