// Laws with a closed return at one point, beside their rate forms by CVODE.
#include "problems.hpp"

#include <scree/rheology/laws/elastic_herschel_bulkley.hpp>
#include <scree/rheology/laws/granular_elastoviscoplastic.hpp>
#include <scree/rheology/stress_measures.hpp>
#include <scree/rheology_stiff/stiff_integrator.hpp>

#include <algorithm>
#include <cmath>

namespace scree::charts {

namespace {

using namespace rheology;

/// What a point goes through: a simple shear with some stretching at constant volume [1/s], for half of the
/// time, then the reverse.
Tensor<double> flow(bool is_back) {
  Tensor<double> gradient;
  gradient(0, 1) = 20;
  gradient(0, 0) = 4;
  gradient(1, 1) = -4;
  gradient(2, 0) = 3;
  return is_back ? -1.0 * gradient : gradient;
}

constexpr long records_each_way =
    8;  // at which errors are taken; CVODE starts anew there, as in a flow's steps

/// A law, its input and density, how long it is led, and its plastic rate [1/s] at a shear stress [Pa].
template <class Law, class PlasticRate>
struct Point {
  Law law;
  typename Law::template Input<double> input;
  double density;   // [kg/m^3]
  double duration;  // [s]
  PlasticRate plastic_rate;
};

/// ds/dt = W s - s W + 2 G (D' - gdot_p s/(2 tau)) of nine components.  Eqs. (R20), (R70)
template <class Law, class PlasticRate>
RateForm rate_form(const Point<Law, PlasticRate>& point, bool is_back) {
  const auto rate = [&point, L = flow(is_back)](double /*t*/, RateForm::Values s, std::span<double> out) {
    const Tensor<double> stretching = deviator(symmetric_part(L));
    double square = 0;
    for (const double component : s) square += component * component;
    const double tau = std::sqrt(square / 2);
    const double flowing = tau > 0 ? point.plastic_rate(tau) / (2 * tau) : 0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        double turning = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          turning += (L(i, k) - L(k, i)) / 2 * s[3 * k + j] - s[3 * i + k] * (L(k, j) - L(j, k)) / 2;
        }
        const double elastic = stretching(i, j) - flowing * s[3 * i + j];
        out[3 * i + j] = turning + 2 * point.law.shear_modulus * elastic;
      }
    }
  };
  return {std::string{Law::name}, rate};
}

/// Leads the point there and back by CVODE. Returns the deviator at all records, nine components each.
template <class Point>
std::vector<double> integrate(const Point& point, const StiffIntegratorOptions& options, Run& run) {
  std::vector<double> s(9, 0.0);
  std::vector<double> records;
  run.steps = 0;
  run.applications = 0;
  for (const bool is_back : {false, true}) {
    StiffIntegrator integrator{9, rate_form(point, is_back), options};
    for (long record = 0; record < records_each_way; ++record) {
      const auto report = integrator.advance(s, 0, point.duration / (2 * records_each_way));
      run.steps += report.steps;
      run.applications += static_cast<double>(report.rate_evaluations);
      records.insert(records.end(), s.begin(), s.end());
    }
  }
  return records;
}

/// The same by the law's own return.
/// @param steps a multiple of the number of records
template <class Point>
std::vector<double> return_closed(const Point& point, long steps) {
  using State = typename decltype(point.law)::template State<double>;
  Response<double, State> response{};
  std::vector<double> records;
  const double dt = point.duration / static_cast<double>(steps);
  for (const bool is_back : {false, true}) {
    const Deformation<double> deformation{flow(is_back), point.density};
    for (long n = 1; n <= steps / 2; ++n) {
      response = point.law.update(deformation, point.input, response.state, dt);
      if (n % (steps / 2 / records_each_way) != 0) continue;
      const Tensor<double> s = deviator(response.stress);
      records.insert(records.end(), s.components.begin(), s.components.end());
    }
  }
  return records;
}

template <class Point>
std::vector<Run> run_point(const std::string& problem, const Point& point, const Extent& extent) {
  constexpr double stress_scale = 1e3;  // [Pa], of tolerances
  std::vector<Run> runs;
  Run ignored;
  const std::vector<double> reference = integrate(point, {1e-11, 1e-11 * stress_scale}, ignored);
  std::vector<double> s;
  for (long steps = 2 * records_each_way; steps <= (extent.is_quick ? 4096 : 16384); steps *= 2) {
    Run run{.problem = problem, .method = "closed_return", .steps = steps};
    run.applications = static_cast<double>(steps);
    run.cpu_seconds = best_cpu_seconds([&] { s = return_closed(point, steps); }, extent.effort);
    run.error = relative_l1(s, reference);
    runs.push_back(run);
  }
  // From 1e-2 on it steps across the pole of the granular rate, at mu_2 p, and is lost.
  for (double tolerance = 1e-3; tolerance > 1e-9; tolerance /= 10) {
    Run run{.problem = problem, .method = "cvode"};
    const StiffIntegratorOptions options{tolerance, tolerance * stress_scale};
    run.cpu_seconds = best_cpu_seconds([&] { s = integrate(point, options, run); }, extent.effort);
    run.error = relative_l1(s, reference);
    runs.push_back(run);
  }
  return runs;
}

}  // namespace

std::vector<Run> granular_point(const Extent& extent) {
  const auto law = typical<GranularElastoviscoplastic>();
  constexpr double p = 1000;           // [Pa]
  constexpr double grain_size = 1e-3;  // [m]
  const auto plastic_rate = [law](double tau) {
    if (tau <= law.mu_s * p) return 0.0;
    const double I = law.I_0 * (tau - law.mu_s * p) / (law.mu_2 * p - tau);
    return I * std::sqrt(p / law.grain_density) / grain_size;
  };
  const double density = law.density * (1 + p / law.bulk_modulus);
  const Point<GranularElastoviscoplastic, decltype(plastic_rate)> point{
      law, {grain_size}, density, 4e-4, plastic_rate};
  return run_point("granular_point", point, extent);
}

std::vector<Run> yield_stress_point(const Extent& extent) {
  const auto law = typical<ElasticHerschelBulkley>();
  const auto plastic_rate = [law](double tau) {
    return std::pow(std::max(tau - law.yield_stress, 0.0) / law.consistency, 1 / law.exponent);
  };
  const Point<ElasticHerschelBulkley, decltype(plastic_rate)> point{law, {}, law.density, 1e-4, plastic_rate};
  return run_point("yield_stress_point", point, extent);
}

}  // namespace scree::charts
