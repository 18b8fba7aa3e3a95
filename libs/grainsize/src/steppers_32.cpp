#include "segregation_steppers.hpp"

namespace scree::grainsize::detail {

template <>
std::unique_ptr<SegregationStepper<1>> make_stepper<1, 32>(const StepperParts<1>& parts) {
  return make_stepper_of_choice<1, 32>(parts);
}
template <>
std::unique_ptr<SegregationStepper<2>> make_stepper<2, 32>(const StepperParts<2>& parts) {
  return make_stepper_of_choice<2, 32>(parts);
}
template <>
std::unique_ptr<SegregationStepper<3>> make_stepper<3, 32>(const StepperParts<3>& parts) {
  return make_stepper_of_choice<3, 32>(parts);
}

}  // namespace scree::grainsize::detail
