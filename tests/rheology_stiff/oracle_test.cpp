// Closed returns of laws against their rate forms, integrated to ten digits.

#include "bodies.hpp"

#include <scree/rheology/laws/granular_elastoviscoplastic.hpp>
#include <scree/rheology_stiff/stiff_integrator.hpp>

#include <gtest/gtest.h>

namespace scree::rheology {
namespace {

using Law = GranularElastoviscoplastic;
constexpr double grain_size = 1e-3;

/// Simple shear with some stretching at constant volume [1/s].
Tensor<double> flow() {
  Tensor<double> gradient;
  gradient(0, 1) = 20;
  gradient(0, 0) = 4;
  gradient(1, 1) = -4;
  gradient(2, 0) = 3;
  return gradient;
}

/// What backward Euler of the law is an approximation of: ds/dt = W s - s W + 2 G (D' - gdot_p s/(2 tau)),
/// with gdot_p from tau = mu(I) p.
RateForm rate_form(const Law& law, double p) {
  RateForm form;
  form.law = std::string{Law::name};
  form.rate = [=](double /*t*/, RateForm::Values s, std::span<double> rate) {
    const Tensor<double> gradient = flow();
    Tensor<double> stress;
    for (std::size_t i = 0; i < 9; ++i) stress.components[i] = s[i];
    const Tensor<double> stretching = deviator(symmetric_part(gradient));
    const double tau = std::sqrt(contract(stress, stress) / 2);
    double plastic = 0;
    if (tau > law.mu_s * p) {
      const double I = law.I_0 * (tau - law.mu_s * p) / (law.mu_2 * p - tau);
      plastic = I * std::sqrt(p / law.grain_density) / grain_size;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        double turning = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          const double w_ik = (gradient(i, k) - gradient(k, i)) / 2;
          const double w_kj = (gradient(k, j) - gradient(j, k)) / 2;
          turning += w_ik * stress(k, j) - stress(i, k) * w_kj;
        }
        const double flowing = tau > 0 ? plastic * stress(i, j) / (2 * tau) : 0;
        rate[3 * i + j] = turning + 2 * law.shear_modulus * (stretching(i, j) - flowing);
      }
    }
  };
  return form;
}

TEST(GranularElastoviscoplastic, ConvergesToItsRateFormWithFirstOrder) {  // Eq. (R20), Eq. (R145)
  const Law law = typical<Law>();
  const double p = 1000;
  const double density = law.density * (1 + p / law.bulk_modulus);
  const double time = 2e-3;  // a few times the start-up, mu p/(G gdot) = 2e-4 s
  std::vector<double> exact(9, 0.0);
  StiffIntegrator oracle{9, rate_form(law, p), {1e-10, 1e-7}};
  const auto report = oracle.advance(exact, 0, time);
  EXPECT_GT(report.steps, 10);

  const auto error = [&](int num_steps) {
    Law::State<double> state{};
    Tensor<double> stress;
    for (int n = 0; n < num_steps; ++n) {
      const auto response = law.update(Deformation<double>{flow(), density}, Law::Input<double>{grain_size},
                                       state, time / num_steps);
      state = response.state;
      stress = deviator(response.stress);
    }
    double result = 0;
    for (std::size_t i = 0; i < 9; ++i) result = std::max(result, std::abs(stress.components[i] - exact[i]));
    return result;
  };
  const double coarse = error(400);
  const double fine = error(800);
  EXPECT_LE(fine, 0.01 * law.mu_2 * p);
  // First order; what is off by second order is a share of the step's turning and return, below a tenth.
  EXPECT_NEAR(std::log2(coarse / fine), 1, 0.1);
}

}  // namespace
}  // namespace scree::rheology
