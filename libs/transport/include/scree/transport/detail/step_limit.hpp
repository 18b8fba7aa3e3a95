#pragma once

#include <scree/tensor.hpp>

#include <optional>
#include <string>

namespace scree::transport::detail {

/// Counts the steps of an advance, and ends it where they collapse.
class StepLimit {
 public:
  /// Steps until waves are, over the whole advance, a thousand times as fast as at its start; or, where
  /// nothing moves at the start, have crossed the grid a thousand times.
  static constexpr double usual_slow_down = 1000;

  /// @param max_steps steps that are allowed; unless given `usual_slow_down` times the sum of duration/first
  /// step and `num_across`  @param num_across cells along the longest way through the grid
  StepLimit(std::optional<Index> max_steps, double duration, Index num_across) noexcept
      : max_steps_{max_steps}, duration_{duration}, num_across_{num_across} {}

  /// Counts steps. @param length of all of them together [s]
  /// @return whether one more is allowed: there are not too many yet, and time does not stand still
  [[nodiscard]] bool allows_more_after(double length, Index num_steps = 1) noexcept;

  /// What became of the step, for people. @param time that was reached [s]
  [[nodiscard]] std::string text(double time) const;

 private:
  [[nodiscard]] double most() const noexcept;
  [[nodiscard]] bool stands_still() const noexcept;

  std::optional<Index> max_steps_;
  double duration_;
  Index num_across_;
  double first_ = 0;  // step [s]
  double last_ = 0;
  Index num_steps_ = 0;
};

}  // namespace scree::transport::detail
