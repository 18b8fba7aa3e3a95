#pragma once

#include <scree/error.hpp>

#include <cstddef>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace scree::test {

/// The rows of a comma-separated file in tests/data, as text; comments (#) and the line of titles left out.
/// @throws InputError if there is no such file.
[[nodiscard]] inline std::vector<std::vector<std::string>> read_table(const std::string& name) {
  std::ifstream file{std::string{SCREE_TEST_DATA "/"} + name};
  if (!file.is_open()) throw InputError{"there is no table " + name};
  std::vector<std::vector<std::string>> rows;
  bool is_title = true;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    if (std::exchange(is_title, false)) continue;
    std::vector<std::string> cells;
    std::istringstream text{line};
    for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
    rows.push_back(std::move(cells));
  }
  return rows;
}

}  // namespace scree::test
