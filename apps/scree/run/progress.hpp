#pragma once

#include <scree/mpm/time_step.hpp>

#include <chrono>
#include <cstdint>

namespace scree::app {

/// Where a run stands, for people.
struct Standing {
  double time;           ///< simulated [s]
  double end;            ///< [s]
  mpm::TimeStep step;    ///< the last one
  double point_updates;  ///< material points x steps since the run began here
};

/// One line about a run: rewritten in place on a terminal, a new line at each tenth of the run elsewhere.
class Progress {
 public:
  /// @param is_quiet prints nothing  @param first_time simulated time at which this run began [s]
  Progress(bool is_quiet, double first_time);

  /// Prints the line if it is time for it.
  void update(const Standing& standing);
  /// Leaves the line as it is, for other text to follow on a fresh one.
  void leave_line() const;
  /// Leaves the terminal on a fresh line.
  void finish(const Standing& standing);

  /// Wall-clock time since the run began here [s].
  [[nodiscard]] double seconds() const;

 private:
  void print(const Standing& standing) const;

  bool is_quiet_;
  bool is_terminal_;
  double first_time_;
  int tenths_ = 0;
  std::int64_t calls_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_ = start_;
};

}  // namespace scree::app
