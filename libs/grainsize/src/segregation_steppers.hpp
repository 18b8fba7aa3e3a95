#pragma once

#include "segregation_stepper.hpp"

namespace scree::grainsize::detail {

/// The stepper with room for N classes, N a power of two. One source file per N compiles these, for all
/// dimensions.
template <int D, int N>
[[nodiscard]] std::unique_ptr<SegregationStepper<D>> make_stepper(const StepperParts<D>& parts);

}  // namespace scree::grainsize::detail
