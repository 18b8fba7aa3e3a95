#include <scree/error.hpp>
#include <scree/rheology_stiff/rkl2.hpp>
#include <scree/rheology_stiff/step_choice.hpp>

#include <array>
#include <cmath>
#include <sstream>

namespace scree::rheology {

namespace {

// Ratios of steps at which the next method becomes cheaper, measured.  Eq. (R144)
constexpr std::array<double, 3> explicit_up_to{5, 3, 3};     // by dimension
constexpr std::array<double, 3> rkl2_up_to{5, 5000, 10000};  // in 1D a solve costs no more than 3 stages
/// What the solves of Newton's method cost, over one for a given viscosity, counted in products of the
/// operator.
constexpr std::array<double, 3> newton_over_linear{6, 3, 2};  // the first ones need not be exact

template <class... Part>
std::string text_of(const Part&... part) {
  std::ostringstream text;
  text.precision(3);
  (text << ... << part);
  return text.str();
}

}  // namespace

ViscousChoice choose_viscous_method(double step, double explicit_step, int dimension, ViscosityIs viscosity) {
  if (!(step >= 0 && std::isfinite(step))) {
    throw InputError{
        text_of("choose_viscous_method: the step is ", step, " s: must be zero or positive, and finite")};
  }
  if (!(explicit_step > 0)) {
    throw InputError{
        text_of("choose_viscous_method: the explicit step is ", explicit_step, " s: must be positive")};
  }
  if (!(1 <= dimension && dimension <= 3)) {
    throw InputError{text_of("choose_viscous_method: ", dimension, " dimensions: must be 1, 2 or 3")};
  }
  const double ratio = step / explicit_step;
  const auto which = static_cast<std::size_t>(dimension - 1);
  // The stages that an implicit step may cost grow with the root of the ratio, Eq. (R142).
  const double solves = viscosity == ViscosityIs::given ? 1 : newton_over_linear[which];
  const double rkl2_most = rkl2_up_to[which] * solves * solves;
  const std::string found =
      text_of("the step of ", step, " s is ", ratio, " times the viscous limit of ", explicit_step, " s");
  if (ratio <= explicit_up_to[which]) {
    const int count = ratio > 1 ? static_cast<int>(std::ceil(ratio)) : 1;
    return {ViscousMethod::explicit_steps, count,
            text_of("viscosity is explicit, ", count, count == 1 ? " step" : " steps", ": ", found,
                    ", not above ", explicit_up_to[which])};
  }
  if (ratio <= rkl2_most) {
    const int stages = rkl2_stages(step, explicit_step);
    return {ViscousMethod::rkl2, stages,
            text_of("viscosity takes a super-time-step of ", stages, " stages: ", found, ", not above ",
                    rkl2_most, " in ", dimension, "D")};
  }
  return {ViscousMethod::implicit, 1,
          text_of("viscosity is implicit: ", found, ", above ", rkl2_most, " in ", dimension, "D")};
}

}  // namespace scree::rheology
