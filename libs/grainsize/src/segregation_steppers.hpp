#pragma once

#include "segregation_stepper.hpp"

#include <variant>

namespace scree::grainsize::detail {

/// The stepper with room for N classes, N a power of two. One source file per N compiles these, for all
/// dimensions and limiters.
template <int D, int N>
[[nodiscard]] std::unique_ptr<SegregationStepper<D>> make_stepper(const StepperParts<D>& parts);

/// The definition of the above, for those files.
template <int D, int N>
[[nodiscard]] std::unique_ptr<SegregationStepper<D>> make_stepper_of_choice(const StepperParts<D>& parts) {
  return std::visit(
      [&]<class Limiter>(const Limiter& limiter) -> std::unique_ptr<SegregationStepper<D>> {
        return std::make_unique<SegregationStepperOf<D, N, Limiter>>(parts, limiter);
      },
      parts.options.limiter);
}

}  // namespace scree::grainsize::detail
