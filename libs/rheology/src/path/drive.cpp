#include "mixed_control.hpp"

#include <scree/error.hpp>
#include <scree/rest_density.hpp>
#include <scree/rheology/dissipation.hpp>
#include <scree/rheology/path/drive.hpp>

#include <cmath>
#include <limits>
#include <sstream>

namespace scree::rheology {

namespace {

using detail::StepRequest;
using detail::StepResult;
using detail::Unknowns;

void validate(const PathOptions& options) {
  std::ostringstream message;
  if (!(options.tolerance > 0 && options.tolerance < 1)) {
    message << "path: tolerance = " << options.tolerance << ": must lie between 0 and 1";
    throw InputError{message.str()};
  }
  if (options.max_iterations < 1) {
    message << "path: max_iterations = " << options.max_iterations << ": must be at least 1";
    throw InputError{message.str()};
  }
}

/// Stresses that a stage asks for after a share of its duration, with respect to its axes [Pa].  Eq. (R28)
[[nodiscard]] std::array<double, 6> wanted_at(const Stage& stage, const Tensor<double>& at_start,
                                              double share) {
  const Tensor<double> start = detail::to_axes(stage.controls.axes, at_start);
  std::array<double, 6> wanted{};
  for (std::size_t k = 0; k < symmetric_components.size(); ++k) {
    const Component& component = symmetric_components[k];
    wanted[k] = start(component.row, component.column) + stage.controls.on[k].rate * (share * stage.duration);
  }
  return wanted;
}

/// The component whose stress is furthest from what is wanted: "stress xy is 644 Pa where 700 Pa is wanted".
[[nodiscard]] std::string worst_of(const StepRequest& request, const StepResult& result) {
  std::ostringstream text;
  Eigen::Index worst = 0;
  result.trial.residual.cwiseAbs().maxCoeff(&worst);
  Eigen::Index unknown = 0;
  for (std::size_t k = 0; k < symmetric_components.size(); ++k) {
    if (request.controls.on[k].of != Control::Of::stress_rate || unknown++ != worst) continue;
    text << "stress " << symmetric_components[k].name << " is "
         << request.wanted[k] + result.trial.residual[worst] << " Pa where " << request.wanted[k]
         << " Pa is wanted, after " << result.iterations << " iterations";
  }
  return text.str();
}

[[nodiscard]] std::string reason_of(const StepRequest& request, const StepResult& result) {
  if (result.trial.is_sound) return worst_of(request, result);
  std::ostringstream text;
  const double density = result.trial.deformation.density;
  if (!(density > 0 && std::isfinite(density))) {
    text << "density becomes " << density << " kg/m^3";
  } else if (result.trial.answer.unsolved != 0) {
    text << "its equations are left with a relative error of " << result.trial.answer.unsolved;
  } else {
    text << "its stress is not finite";
  }
  return text.str();
}

[[noreturn]] void give_up(const PathPoint& point, const Stage& stage, std::size_t number, double time,
                          const std::string& reason) {
  std::ostringstream message;
  message << "the law '" << point.law() << "' has no answer in stage " << number + 1 << " '" << stage.name
          << "' at " << time << " s: " << reason;
  throw RunError{message.str()};
}

/// Rates of the normal components that are not imposed with which the volume stays, the same for each.
[[nodiscard]] Unknowns at_constant_volume(const Controls& controls) {
  const std::size_t num_rates = detail::num_unknowns(controls);
  Unknowns rates = Unknowns::Zero(static_cast<Eigen::Index>(num_rates));
  double imposed = 0;
  Eigen::Index num_normals = 0;  // which come before the shears, among the unknown rates too
  for (std::size_t k = 0; k < first_shear; ++k) {
    if (controls.on[k].of == Control::Of::stress_rate) {
      ++num_normals;
    } else {
      imposed += controls.on[k].rate;
    }
  }
  if (num_normals > 0) rates.head(num_normals).setConstant(-imposed / static_cast<double>(num_normals));
  return rates;
}

/// From a first guess and, should that lead nowhere, from constant volume and from rest.
[[nodiscard]] StepResult solve(const PathPoint& point, const StepRequest& request, const Unknowns& guess,
                               const PathOptions& options) {
  StepResult result = detail::solve_step(point, request, guess, options);
  const std::array others{at_constant_volume(request.controls), Unknowns{Unknowns::Zero(guess.size())}};
  for (const Unknowns& other : others) {
    if (result.is_met) break;
    const StepResult again = detail::solve_step(point, request, other, options);
    if (again.is_met || !result.trial.is_sound) result = again;
  }
  return result;
}

[[nodiscard]] PathRecord record_of(const PathPoint& point, std::size_t stage, const StepResult& step,
                                   double start_density) {
  const Deformation<double> deformation{step.trial.deformation.velocity_gradient, point.now.density};
  PathRecord record;
  record.stage = stage;
  record.at = point.now;
  record.velocity_gradient = deformation.velocity_gradient;
  record.pressure = mean_pressure(point.now.stress);
  record.deviatoric_stress = deviatoric_stress(point.now.stress);
  record.lode_angle = lode_angle(point.now.stress);
  record.volumetric_strain = std::log(start_density / point.now.density);
  record.shear_rate = shear_rate(deformation.velocity_gradient);
  record.inertial_number = point.inertial_number(deformation);
  record.dissipation = dissipation(point.now.stress, deformation.velocity_gradient);
  record.stability_number = point.stability_number(deformation);
  record.iterations = step.iterations;
  record.state = point.state();
  return record;
}

void take(PathPoint& point, const StepResult& step, double dt, double time) {
  point.remember(step.trial.deformation, dt);
  point.now.time = time;
  point.now.density = step.trial.deformation.density;
  point.now.strain += dt * symmetric_part(step.trial.deformation.velocity_gradient);
  point.now.stress = step.trial.answer.stress;
}

void drive_stage(PathPoint& point, const Stage& stage, std::size_t number, const PathOptions& options,
                 std::vector<PathRecord>& records, double start_density) {
  const PathState start = point.now;
  const double dt = stage.duration / static_cast<double>(stage.num_steps);
  Unknowns rates = at_constant_volume(stage.controls);
  for (Index n = 1; n <= stage.num_steps; ++n) {
    const double share = static_cast<double>(n) / static_cast<double>(stage.num_steps);
    const double time = start.time + share * stage.duration;
    const StepRequest request{stage.controls, wanted_at(stage, start.stress, share), dt};
    const StepResult step = solve(point, request, rates, options);
    if (!step.is_met) give_up(point, stage, number, time, reason_of(request, step));
    take(point, step, dt, time);
    records.push_back(record_of(point, number, step, start_density));
    rates = step.rates;
  }
}

}  // namespace

void drive(PathPoint& point, std::span<const Stage> stages, const PathOptions& options,
           std::vector<PathRecord>& records) {
  validate(options);
  for (const Stage& stage : stages) validate(stage);
  const double start_density = point.now.density;
  records.push_back(record_of(point, 0, {}, start_density));
  for (std::size_t i = 0; i < stages.size(); ++i) {
    drive_stage(point, stages[i], i, options, records, start_density);
  }
}

std::vector<PathRecord> drive(PathPoint& point, std::span<const Stage> stages, const PathOptions& options) {
  std::vector<PathRecord> records;
  drive(point, stages, options, records);
  return records;
}

/// By the secant rule; a linear equation of state takes one step.
double density_at_pressure(const PathPoint& point, double pressure) {
  std::ostringstream message;
  if (!(pressure >= 0 && std::isfinite(pressure))) {
    message << "path: pressure = " << pressure << " Pa: must be finite and at least 0";
    throw InputError{message.str()};
  }
  const auto excess = [&](double density) {
    return mean_pressure(point.answer({Tensor<double>{}, density}, 0).stress) - pressure;
  };
  if (const auto density = rest_density(excess, point.now.density)) return *density;
  message << "the law '" << point.law() << "' has no density at which its pressure is " << pressure << " Pa";
  throw RunError{message.str()};
}

}  // namespace scree::rheology
