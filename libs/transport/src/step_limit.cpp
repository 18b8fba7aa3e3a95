#include <scree/transport/detail/step_limit.hpp>

#include <sstream>

namespace scree::transport::detail {

bool StepLimit::allows_more_after(double length, Index num_steps) noexcept {
  last_ = length / static_cast<double>(num_steps);
  if (num_steps_ == 0) first_ = last_;
  num_steps_ += num_steps;
  return static_cast<double>(num_steps_) < most() && !stands_still();
}

std::string StepLimit::text(double time) const {
  std::ostringstream text;
  text << "the time step fell from " << first_ << " s to " << last_ << " s in " << num_steps_
       << " steps, at time " << time << " s: ";
  if (stands_still()) {
    text << "below the round-off of the duration, " << duration_ << " s";
  } else {
    text << "more steps than " << (max_steps_ ? "max_steps" : "a flow of such waves as at the start takes");
  }
  return text.str();
}

double StepLimit::most() const noexcept {
  if (max_steps_) return static_cast<double>(*max_steps_);
  return usual_slow_down * (duration_ / first_ + static_cast<double>(num_across_));
}

bool StepLimit::stands_still() const noexcept {
  return !(last_ > round_off * duration_);
}

}  // namespace scree::transport::detail
