#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace scree::charts {

/// A problem that a program of charts runs by its name.
struct Problem {
  std::string name;
  /// Writes its rows as they are done.  @param is_quick little of it: to try it
  std::function<void(bool is_quick, std::ostream& table)> run;
};

/// A program that runs problems and writes a table of their errors and costs.
struct Program {
  std::string name;
  std::string summary;                                    ///< what the table is of, for people
  std::string quick;                                      ///< what is run when it is only tried, for people
  std::function<void(std::ostream& table)> write_titles;  ///< of the columns
  std::vector<Problem> problems;
};

/// Reads the command line and runs the chosen problems, or all; what is done is in the table at once.
/// @returns the exit code; what fails is printed
[[nodiscard]] int run_program(const Program& program, int argc, char** argv);

}  // namespace scree::charts
