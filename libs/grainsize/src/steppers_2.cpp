#include "segregation_steppers.hpp"

namespace scree::grainsize::detail {

template <>
std::unique_ptr<SegregationStepper<1>> make_stepper<1, 2>(const StepperParts<1>& parts) {
  return std::make_unique<SegregationStepperOf<1, 2>>(parts);
}
template <>
std::unique_ptr<SegregationStepper<2>> make_stepper<2, 2>(const StepperParts<2>& parts) {
  return std::make_unique<SegregationStepperOf<2, 2>>(parts);
}
template <>
std::unique_ptr<SegregationStepper<3>> make_stepper<3, 2>(const StepperParts<3>& parts) {
  return std::make_unique<SegregationStepperOf<3, 2>>(parts);
}

}  // namespace scree::grainsize::detail
