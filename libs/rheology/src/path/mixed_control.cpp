#include "mixed_control.hpp"

#include <scree/rheology/kinematics.hpp>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace scree::rheology::detail {

namespace {

using Jacobian = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;

[[nodiscard]] bool is_unknown(const Controls& controls, std::size_t k) noexcept {
  return controls.on[k].of == Control::Of::stress_rate;
}

[[nodiscard]] Tensor<double> transposed(const Tensor<double>& a) noexcept {
  Tensor<double> result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result(i, j) = a(j, i);
  }
  return result;
}

[[nodiscard]] double largest(const Tensor<double>& a) noexcept {
  double result = 0;
  for (const double component : a.components) result = std::max(result, std::abs(component));
  return result;
}

/// L of the controls, in fixed axes, once the unknown rates are given.  Eq. (R28)
[[nodiscard]] Tensor<double> velocity_gradient(const Controls& controls, const Unknowns& rates) noexcept {
  Tensor<double> gradient;
  Eigen::Index unknown = 0;
  for (std::size_t k = 0; k < symmetric_components.size(); ++k) {
    const auto [name, i, j] = symmetric_components[k];
    const double rate = is_unknown(controls, k) ? rates[unknown++] : controls.on[k].rate;
    if (k < first_shear) {
      gradient(i, i) = rate;
      continue;
    }
    const std::size_t shear = k - first_shear;
    const double spin = controls.spin[shear];
    gradient(i, j) = (controls.is_simple_shear[shear] ? 2 * rate : rate) + spin;
    gradient(j, i) = (controls.is_simple_shear[shear] ? 0 : rate) - spin;
  }
  return from_axes(controls.axes, gradient);
}

[[nodiscard]] Trial try_step(const PathPoint& point, const StepRequest& request, const Unknowns& rates) {
  const Tensor<double> gradient = velocity_gradient(request.controls, rates);
  Trial trial;
  trial.deformation = {gradient, point.now.density / (1 + request.dt * trace(gradient))};  // Eq. (R27)
  const double density = trial.deformation.density;
  if (!(density > 0 && std::isfinite(density))) return trial;
  trial.answer = point.answer(trial.deformation, request.dt);
  const Tensor<double> stress = to_axes(request.controls.axes, trial.answer.stress);
  trial.residual.resize(rates.size());
  Eigen::Index unknown = 0;
  for (std::size_t k = 0; k < symmetric_components.size(); ++k) {
    if (!is_unknown(request.controls, k)) continue;
    const auto [name, i, j] = symmetric_components[k];
    trial.residual[unknown++] = stress(i, j) - request.wanted[k];
  }
  const auto& components = stress.components;
  trial.is_sound = trial.answer.unsolved == 0 &&
                   std::ranges::all_of(components, [](double value) { return std::isfinite(value); });
  return trial;
}

/// Sizes that make a step's numbers comparable.
struct Scales {
  double stress;     ///< the largest that is there or wanted [Pa]
  double tolerance;  ///< of a stress [Pa]
  double rate;       ///< that changes the stress by its own size in the step, or is imposed [1/s]
};

[[nodiscard]] Scales scales_of(const PathPoint& point, const StepRequest& request, double relative) {
  Scales scales{largest(point.now.stress), 0, 0};
  for (std::size_t k = 0; k < symmetric_components.size(); ++k) {
    if (is_unknown(request.controls, k)) {
      scales.stress = std::max(scales.stress, std::abs(request.wanted[k]));
    } else {
      scales.rate = std::max(scales.rate, std::abs(request.controls.on[k].rate));
    }
  }
  const Tensor<double> imposed = velocity_gradient(
      request.controls, Unknowns::Zero(static_cast<Eigen::Index>(num_unknowns(request.controls))));
  const Stiffness<double> stiffness = point.stiffness({imposed, point.now.density});
  const double modulus = point.now.density * stiffness.wave_speed * stiffness.wave_speed;  // [Pa]
  constexpr double operations = 100;  // on strains, numbers of order one, in the stress of a law
  scales.tolerance = relative * scales.stress + operations * round_off * modulus;
  // A strain of one, in material that is too soft to come to that stress.
  const double change =
      std::min(1 / request.dt, scales.stress / (modulus * request.dt + stiffness.viscosity));
  scales.rate = std::max(scales.rate, change);
  return scales;
}

/// By differences towards compression, where material that is about to let go still answers.
[[nodiscard]] Jacobian jacobian(const PathPoint& point, const StepRequest& request, const StepResult& at,
                                double rate_scale) {
  const Eigen::Index n = at.rates.size();
  const double scale = std::max(rate_scale, at.rates.cwiseAbs().maxCoeff());
  Jacobian result(n, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    Unknowns rates = at.rates;
    rates[k] -= std::sqrt(round_off) * scale;
    const double difference = rates[k] - at.rates[k];
    const Trial trial = try_step(point, request, rates);
    if (trial.is_sound) {
      result.col(k) = (trial.residual - at.trial.residual) / difference;
    } else {
      result.col(k).setZero();
    }
  }
  return result;
}

/// Goes down along a direction until the residual has become smaller; false if it nowhere does.
[[nodiscard]] bool search_line(const PathPoint& point, const StepRequest& request, const Unknowns& direction,
                               StepResult& at) {
  constexpr int max_halvings = 40;
  constexpr double decrease = 1e-4;  // of the residual, as a share of what the linear model promises
  double share = 1;
  for (int i = 0; i < max_halvings; ++i, share /= 2) {
    const Unknowns rates = at.rates + share * direction;
    const Trial trial = try_step(point, request, rates);
    if (!trial.is_sound || !(trial.residual.norm() <= (1 - decrease * share) * at.trial.residual.norm()))
      continue;
    at.rates = rates;
    at.trial = trial;
    return true;
  }
  return false;
}

}  // namespace

Tensor<double> from_axes(const Tensor<double>& axes, const Tensor<double>& a) noexcept {
  return product(product(axes, a), transposed(axes));
}

Tensor<double> to_axes(const Tensor<double>& axes, const Tensor<double>& a) noexcept {
  return product(product(transposed(axes), a), axes);
}

std::size_t num_unknowns(const Controls& controls) noexcept {
  return static_cast<std::size_t>(std::ranges::count_if(
      controls.on, [](const Control& control) { return control.of == Control::Of::stress_rate; }));
}

StepResult solve_step(const PathPoint& point, const StepRequest& request, const Unknowns& guess,
                      const PathOptions& options) {
  const Scales scales = scales_of(point, request, options.tolerance);
  StepResult result;
  result.rates = guess;
  result.trial = try_step(point, request, guess);
  if (!result.trial.is_sound) return result;
  for (;; ++result.iterations) {
    const Unknowns& residual = result.trial.residual;
    result.is_met = residual.size() == 0 || residual.cwiseAbs().maxCoeff() <= scales.tolerance;
    if (result.is_met || result.iterations == options.max_iterations) return result;
    const Unknowns direction =
        jacobian(point, request, result, scales.rate).completeOrthogonalDecomposition().solve(-residual);
    if (!direction.allFinite() || !search_line(point, request, direction, result)) return result;
  }
}

}  // namespace scree::rheology::detail
