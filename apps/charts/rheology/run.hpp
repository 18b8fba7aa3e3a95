#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace scree::charts {

/// One way to advance one problem: what it costs, and how far it is from the reference at the end.
struct Run {
  std::string problem{};
  double parameter = 0;  ///< what makes the problem stiff, in the unit that it states; 0 for points
  std::string method{};
  long steps = 0;
  double ratio = 0;         ///< of the step to the longest stable explicit one [-]; 0 for points
  double applications = 0;  ///< of the viscous operator or of the law, in all
  double cpu_seconds = 0;   ///< [s], best of several
  double error = 0;         ///< L1 norm of the difference over that of the reference [-]
};

/// Writes the titles of the columns, comma-separated.
void write_titles(std::ostream& out);

/// Writes one line for each run, and flushes.
void write_rows(const std::vector<Run>& runs, std::ostream& out);

/// sum |values - reference| / sum |reference| [-].
[[nodiscard]] double relative_l1(const std::vector<double>& values, const std::vector<double>& reference);

}  // namespace scree::charts
