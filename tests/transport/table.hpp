#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace scree::transport::test {

/// A row of a table in tests/data/transport, its entries by the name of their column.
struct Row {
  std::vector<std::string> columns;
  std::vector<std::string> entries;

  [[nodiscard]] const std::string& text(const std::string& column) const {
    const auto found = std::find(columns.begin(), columns.end(), column);
    if (found == columns.end()) throw std::runtime_error{"no column " + column};
    return entries.at(static_cast<std::size_t>(found - columns.begin()));
  }
  [[nodiscard]] double number(const std::string& column) const { return std::stod(text(column)); }
  [[nodiscard]] std::int64_t cells() const { return std::stol(text("cells")); }
};

inline std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> parts;
  std::istringstream text{line};
  for (std::string part; std::getline(text, part, ',');) parts.push_back(part);
  return parts;
}

/// All rows of a table: comma-separated, comments start with #, the first other line names the columns.
inline std::vector<Row> table(const std::string& name) {
  std::ifstream file{std::string{SCREE_TEST_DATA "/transport/"} + name};
  if (!file) throw std::runtime_error{"cannot read " + name};
  std::vector<Row> rows;
  std::vector<std::string> columns;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.front() == '#') continue;
    if (columns.empty()) {
      columns = split(line);
    } else {
      rows.push_back({columns, split(line)});
    }
  }
  return rows;
}

/// The rows with an entry in a column.
inline std::vector<Row> rows_with(std::vector<Row> rows, const std::string& column,
                                  const std::string& entry) {
  std::erase_if(rows, [&](const Row& row) { return row.text(column) != entry; });
  return rows;
}

/// Names a test for what comes before the results in its row: the entries up to the number of cells.
inline std::string name_of(const ::testing::TestParamInfo<Row>& info) {
  std::string name;
  for (std::size_t i = 0; i < info.param.columns.size(); ++i) {
    name += (i == 0 ? "" : "_") + info.param.entries[i];
    if (info.param.columns[i] == "cells") break;
  }
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

inline void PrintTo(const Row& row, std::ostream* out) {
  for (const auto& entry : row.entries) *out << entry << ' ';
}

}  // namespace scree::transport::test
