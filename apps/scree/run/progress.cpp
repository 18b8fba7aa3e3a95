#include "scree/run/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace scree::app {

namespace {

[[nodiscard]] double seconds_between(std::chrono::steady_clock::time_point a,
                                     std::chrono::steady_clock::time_point b) {
  return std::chrono::duration<double>(b - a).count();
}

[[nodiscard]] std::string as_minutes(double seconds) {
  if (seconds < 100) return fmt::format("{:.0f} s", seconds);
  return fmt::format("{:.0f} min {:02.0f} s", seconds / 60,
                     static_cast<double>(static_cast<int>(seconds) % 60));
}

}  // namespace

Progress::Progress(bool is_quiet, double first_time)
    : is_quiet_{is_quiet}, is_terminal_{isatty(STDOUT_FILENO) == 1}, first_time_{first_time} {}

double Progress::seconds() const {
  return seconds_between(start_, std::chrono::steady_clock::now());
}

void Progress::print(const Standing& standing) const {
  const double wall = seconds();
  const double done = standing.time - first_time_;
  const double left = done > 0 ? wall * (standing.end - standing.time) / done : 0;
  const std::string line = fmt::format("{:3.0f} %  t = {:.3f} s  dt = {:.2e} s ({})  {:.2f} Mpts/s  {} left",
                                       100 * standing.time / standing.end, standing.time, standing.step.dt,
                                       mpm::limit_names[static_cast<std::size_t>(standing.step.limit)],
                                       standing.point_updates / wall / 1e6, as_minutes(left));
  if (is_terminal_) {
    fmt::print("\r{:<78}", line);
  } else {
    fmt::print("{}\n", line);
  }
  std::fflush(stdout);
}

void Progress::update(const Standing& standing) {
  if (is_quiet_) return;
  if (!is_terminal_) {
    const int tenths = static_cast<int>(10 * standing.time / standing.end);
    if (tenths > tenths_ && tenths < 10) print(standing);
    tenths_ = tenths;
    return;
  }
  constexpr std::int64_t calls_per_look = 64;  // a look at the clock is dear beside a small step
  if (++calls_ % calls_per_look != 0) return;
  const auto now = std::chrono::steady_clock::now();
  constexpr double between_lines = 0.2;  // [s]
  if (seconds_between(last_, now) < between_lines) return;
  last_ = now;
  print(standing);
}

void Progress::leave_line() const {
  if (!is_quiet_ && is_terminal_ && calls_ > 0) fmt::print("\n");
  std::fflush(stdout);
}

void Progress::finish(const Standing& standing) {
  if (is_quiet_) return;
  print(standing);
  if (is_terminal_) fmt::print("\n");
}

}  // namespace scree::app
