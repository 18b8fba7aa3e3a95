#pragma once

#include "lines.hpp"

#include <scree/transport/components.hpp>
#include <scree/transport_stiff/imex_integrator.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace scree::transport::test {

inline constexpr double no_bound = std::numeric_limits<double>::infinity();
inline const double gamma_ssp2 = 1 - std::sqrt(0.5);

inline constexpr std::array all_methods{ImexMethod::ssp2, ImexMethod::ars2, ImexMethod::ark3,
                                        ImexMethod::ark4, ImexMethod::ark5};

/// Which half of an equation is explicit.
enum class Split { linear_part, all, nothing };

/// u' = cos(t) (u - u^2).
inline ImexProblem logistic(Split split) {
  using Values = ImexProblem::Values;
  const auto grow = [](double t, double u) { return std::cos(t) * u; };
  const auto shrink = [](double t, double u) { return -std::cos(t) * u * u; };
  ImexProblem problem;
  if (split != Split::nothing) {
    problem.explicit_rate = [=](double t, Values u, std::span<double> rate) {
      rate[0] = grow(t, u[0]) + (split == Split::all ? shrink(t, u[0]) : 0);
      return no_bound;
    };
  }
  if (split != Split::all) {
    problem.implicit_rate = [=](double t, Values u, std::span<double> rate) {
      rate[0] = shrink(t, u[0]) + (split == Split::nothing ? grow(t, u[0]) : 0);
    };
  }
  return problem;
}

/// Its solution at t, from u0 at t0.
inline double logistic_at(double t, double t0, double u0) {
  return 1 / (1 + (1 / u0 - 1) * std::exp(std::sin(t0) - std::sin(t)));
}

/// u' = -sin t [explicit] - lambda (u - cos t) [implicit], from u(0) = 1: u = cos t whatever lambda.
inline ImexProblem prothero_robinson(double lambda) {
  using Values = ImexProblem::Values;
  ImexProblem problem;
  problem.explicit_rate = [](double t, Values /*u*/, std::span<double> rate) {
    rate[0] = -std::sin(t);
    return no_bound;
  };
  problem.implicit_rate = [=](double t, Values u, std::span<double> rate) {
    rate[0] = -lambda * (u[0] - std::cos(t));
  };
  return problem;
}

/// u' = -lambda u, as one half or the other.
inline ImexProblem decay(double lambda, bool is_explicit) {
  using Values = ImexProblem::Values;
  const auto rate_of = [=](Values u, std::span<double> rate) { rate[0] = -lambda * u[0]; };
  ImexProblem problem;
  if (is_explicit) {
    problem.explicit_rate = [=](double /*t*/, Values u, std::span<double> rate) {
      rate_of(u, rate);
      return no_bound;
    };
  } else {
    problem.implicit_rate = [=](double /*t*/, Values u, std::span<double> rate) { rate_of(u, rate); };
  }
  return problem;
}

/// Advection with a constant velocity, diffusion with a constant diffusivity.
struct AdvectionDiffusion {
  static constexpr int num_components = 1;
  using State = std::array<double, 1>;
  double velocity;     // along every axis [m/s]
  double diffusivity;  // [m^2/s]

  template <int D>
  State flux(const State& u, const Vector<D>& normal) const noexcept {
    return {velocity * sum<D>(normal) * u[0]};
  }
  template <int D>
  double max_speed(const State& /*left*/, const State& /*right*/, const Vector<D>& normal) const noexcept {
    return std::abs(velocity * sum<D>(normal));
  }
  State potential(const State& u) const noexcept { return {diffusivity * u[0]}; }
  double max_diffusivity(const State& /*left*/, const State& /*right*/) const noexcept { return diffusivity; }
};

/// Burgers' equation with viscosity, in any dimension: K(u) = nu (u + u^3).
struct NonlinearDiffusion {
  static constexpr int num_components = 1;
  using State = std::array<double, 1>;
  double viscosity;

  template <int D>
  State flux(const State& u, const Vector<D>& normal) const noexcept {
    return {sum<D>(normal) * u[0] * u[0] / 2};
  }
  template <int D>
  double max_speed(const State& left, const State& right, const Vector<D>& /*normal*/) const noexcept {
    return larger(std::abs(left[0]), std::abs(right[0]));
  }
  State potential(const State& u) const noexcept { return {viscosity * (u[0] + u[0] * u[0] * u[0])}; }
  double max_diffusivity(const State& left, const State& right) const noexcept {
    return viscosity * (1 + 3 * larger(left[0] * left[0], right[0] * right[0]));
  }
};

}  // namespace scree::transport::test
