#include <scree/error.hpp>
#include <scree/rheology/kinematics.hpp>
#include <scree/rheology/path/paths.hpp>
#include <scree/rheology/path/stage.hpp>

#include <cmath>
#include <sstream>

namespace scree::rheology {

namespace {

void check(bool condition, const Stage& stage, std::string_view what, double value,
           std::string_view expected) {
  if (condition) return;
  std::ostringstream message;
  message << "stage '" << stage.name << "': " << what << " = " << value << ": " << expected;
  throw InputError{message.str()};
}

/// Largest component of Q^T Q - 1.
[[nodiscard]] double distance_from_rotation(const Tensor<double>& q) noexcept {
  const Tensor<double> rest = carried_by(q, isotropic(1.0)) - isotropic(1.0);
  double largest = 0;
  for (const double component : rest.components) {
    if (!(std::abs(component) <= largest)) largest = std::abs(component);
  }
  return largest;
}

}  // namespace

void validate(const Stage& stage) {
  check(stage.duration > 0 && std::isfinite(stage.duration), stage, "duration", stage.duration,
        "must be finite and above 0 s");
  check(stage.num_steps >= 1, stage, "num_steps", static_cast<double>(stage.num_steps), "must be at least 1");
  for (std::size_t k = 0; k < symmetric_components.size(); ++k) {
    const Control& control = stage.controls.on[k];
    const bool is_strain = control.of == Control::Of::strain_rate;
    check(std::isfinite(control.rate), stage,
          (is_strain ? "strain rate " : "stress rate ") + std::string{symmetric_components[k].name},
          control.rate, "must be finite");
  }
  for (std::size_t k = first_shear; k < symmetric_components.size(); ++k) {
    const double spin = stage.controls.spin[k - first_shear];
    check(std::isfinite(spin), stage, "spin " + std::string{symmetric_components[k].name}, spin,
          "must be finite");
  }
  constexpr double typed_digits = 1e-9;  // [-], what axes that someone typed may lack
  const double distance = distance_from_rotation(stage.controls.axes);
  check(distance <= typed_digits, stage, "axes", distance, "is how far they are from a rotation, must be 0");
}

Controls isotropic_compression(double rate) noexcept {
  Controls controls;
  for (std::size_t k = 0; k < first_shear; ++k) controls.on[k] = stress_rate(-rate);
  return controls;
}

Controls oedometric(double rate) noexcept {
  Controls controls;
  controls.on[1] = strain_rate(-rate);
  return controls;
}

Controls triaxial_drained(double rate) noexcept {
  Controls controls = oedometric(rate);
  controls.on[0] = controls.on[2] = stress_rate(0);
  return controls;
}

Controls triaxial_undrained(double rate) noexcept {
  Controls controls = oedometric(rate);
  controls.on[0] = controls.on[2] = strain_rate(rate / 2);
  return controls;
}

Controls simple_shear_at_constant_pressure(double rate) noexcept {
  Controls controls = simple_shear_at_constant_volume(rate);
  controls.on[1] = stress_rate(0);
  return controls;
}

Controls simple_shear_at_constant_volume(double rate) noexcept {
  Controls controls;
  controls.on[first_shear] = strain_rate(rate / 2);
  controls.is_simple_shear[0] = true;
  return controls;
}

Controls rotation(double rate) noexcept {
  Controls controls;
  controls.spin[0] = -rate;
  return controls;
}

}  // namespace scree::rheology
