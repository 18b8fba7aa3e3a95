#include "arkode_callbacks.hpp"

#include "arkode_handles.hpp"

#include <scree/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace scree::transport::detail {

void ArkodeCallbacks::start() noexcept {
  guard_.start();
  said_.clear();
  explicit_evaluations_ = implicit_evaluations_ = 0;
  shortest_ = std::numeric_limits<double>::infinity();
}

double ArkodeCallbacks::stable_step(double time, N_Vector u, N_Vector rate) {
  if (!problem_.explicit_rate) return std::numeric_limits<double>::infinity();
  return evaluate_explicit(time, u, rate);
}

double ArkodeCallbacks::take_shortest() noexcept {
  return std::exchange(shortest_, std::numeric_limits<double>::infinity());
}

double ArkodeCallbacks::evaluate_explicit(double time, N_Vector u, N_Vector rate) {
  const double bound = problem_.explicit_rate(time, values(u), values(rate));
  if (!(bound > 0)) {
    std::ostringstream text;
    text << "ImexIntegrator: the explicit rate's stable step is " << bound << " s at time " << time
         << " s: must be positive";
    throw RunError{text.str()};
  }
  ++explicit_evaluations_;
  shortest_ = std::min(shortest_, bound);
  return bound;
}

void ArkodeCallbacks::evaluate_implicit(double time, N_Vector u, N_Vector rate) {
  ++implicit_evaluations_;
  problem_.implicit_rate(time, values(u), values(rate));
}

/// J v from the implicit rate at u and beside it. (ARKODE's own difference moves u by no more than the
/// tolerances, and so is noise where these are tight.)  Eq. (T54)
void ArkodeCallbacks::difference(double time, N_Vector u, N_Vector rate, N_Vector v, N_Vector product,
                                 N_Vector beside) {
  const auto here = values(u);
  const auto direction = values(v);
  double sum = 0;
  for (std::size_t i = 0; i < here.size(); ++i) {
    const double relative = direction[i] / (std::abs(here[i]) + typical_);
    sum += relative * relative;
  }
  if (sum == 0) return N_VConst(0, product);
  const double half_digits = std::sqrt(std::numeric_limits<double>::epsilon());
  const double step = half_digits / std::sqrt(sum / static_cast<double>(here.size()));
  N_VLinearSum(1, u, step, v, beside);
  evaluate_implicit(time, beside, product);
  N_VLinearSum(1 / step, product, -1 / step, rate, product);
}

template <class Body>
int ArkodeCallbacks::guard(void* self, Body&& body) noexcept {
  auto& callbacks = *static_cast<ArkodeCallbacks*>(self);
  return callbacks.guard_.run([&] { body(callbacks); });
}

int ArkodeCallbacks::explicit_rate(double time, N_Vector u, N_Vector rate, void* self) noexcept {
  return guard(self, [&](ArkodeCallbacks& calls) { calls.evaluate_explicit(time, u, rate); });
}

int ArkodeCallbacks::implicit_rate(double time, N_Vector u, N_Vector rate, void* self) noexcept {
  return guard(self, [&](ArkodeCallbacks& calls) { calls.evaluate_implicit(time, u, rate); });
}

int ArkodeCallbacks::jacobian_product(N_Vector v, N_Vector product, double time, N_Vector u, N_Vector rate,
                                      void* self, N_Vector work) noexcept {
  return guard(self, [&](ArkodeCallbacks& calls) {
    if (!calls.problem_.jacobian_product) return calls.difference(time, u, rate, v, product, work);
    calls.problem_.jacobian_product(time, values(u), values(v), values(product));
  });
}

int ArkodeCallbacks::prepare(double time, N_Vector u, N_Vector /*rate*/, int /*is_jacobian_fine*/,
                             int* is_jacobian_new, double gamma, void* self) noexcept {
  *is_jacobian_new = SUNTRUE;
  return guard(
      self, [&](ArkodeCallbacks& calls) { calls.problem_.prepare_preconditioner(time, values(u), gamma); });
}

int ArkodeCallbacks::precondition(double /*time*/, N_Vector /*u*/, N_Vector /*rate*/, N_Vector residual,
                                  N_Vector z, double /*gamma*/, double /*tolerance*/, int /*side*/,
                                  void* self) noexcept {
  return guard(self,
               [&](ArkodeCallbacks& calls) { calls.problem_.precondition(values(residual), values(z)); });
}

int ArkodeCallbacks::bound_step(N_Vector /*u*/, double /*time*/, double* step, void* self) noexcept {
  return guard(self, [&](ArkodeCallbacks& calls) {
    const double bound = calls.take_shortest();
    *step = std::isfinite(bound) ? bound : -1;  // ARKODE's sign for: none
  });
}

void ArkodeCallbacks::keep_message(int code, const char* /*module*/, const char* /*function*/, char* text,
                                   void* self) noexcept {
  if (code == ARK_WARNING) return;
  guard(self, [&](ArkodeCallbacks& calls) { calls.said_ = text; });
}

}  // namespace scree::transport::detail
