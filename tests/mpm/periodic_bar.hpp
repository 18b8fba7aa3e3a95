#pragma once

#include "bodies.hpp"

#include <scree/mpm/critical_step.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace scree::mpm {

/// A periodic bar and how it is advanced.
struct Bar {
  static constexpr Index num_cells = 32;  ///< every other wave of those that critical_sums() looks at
  static constexpr double spacing = 0.125;

  AnyShape shape;
  AnyTransfer transfer;
  Order order = Order::usl;
  Index per_cell = 1;
  double offset = 0;   ///< of all points from the middle of their parts of a cell [spacings]
  double viscous = 0;  ///< share of the sum (M173) that viscosity has [-]
  int xpic_order = 0;  ///< of the filter of velocities; 0: there is none
};

[[nodiscard]] inline Particles<1, 1> points_of(const Bar& bar) {
  auto particles = filled<1>(cube<1>(Bar::num_cells, Bar::spacing, true), bar.per_cell);
  for (double& x : particles.position.values()) x += bar.offset * Bar::spacing;
  return particles;
}

[[nodiscard]] inline double critical_sum_of(const Bar& bar) {
  return critical_sums(points_of(bar), cube<1>(Bar::num_cells, Bar::spacing, true), bar.shape, bar.transfer,
                       bar.order, bar.xpic_order)[0];
}

/// In words, for messages.
[[nodiscard]] inline std::string name_of(const Bar& bar) {
  const auto name = [](const auto& entry) { return entry.name; };
  std::ostringstream text;
  text << std::visit(name, bar.shape) << " " << std::visit(name, bar.transfer) << " "
       << order_names[static_cast<std::size_t>(bar.order)] << ", " << bar.per_cell << " points a cell at "
       << bar.offset << ", viscosity " << bar.viscous << ", XPIC " << bar.xpic_order;
  return text.str();
}

/// A law with which steps of dt have that sum, viscosity its share of it.
[[nodiscard]] inline Fluid fluid_of(double sum, double viscous, double dt) {
  const double speed = std::sqrt((1 - viscous) * sum) * Bar::spacing / dt;
  return {.bulk_modulus = 1000 * speed * speed,
          .reference_density = 1000,
          .viscosity = 1000 * viscous * sum * 3.0 / 8 * Bar::spacing * Bar::spacing / dt};
}

/// A fluid whose modulus and viscosity are at each point as many times those of the law.
struct Patchwork {
  static constexpr std::string_view name = "patchwork";
  template <class Real>
  struct Input {
    Real share;  // [-]
  };
  static constexpr std::array<InputColumn, 1> inputs{{{"share", "-", 1}}};
  template <class Real>
  struct State {};
  static constexpr std::array<StateColumn, 0> states{};

  Fluid fluid;

  template <class Real>
  [[nodiscard]] Response<Real, State<Real>> update(const Deformation<Real>& deformation,
                                                   const Input<Real>& input, const State<Real>& /*old*/,
                                                   Real dt) const noexcept {
    return {input.share * fluid.update(deformation, Fluid::Input<Real>{}, Fluid::State<Real>{}, dt).stress,
            {}};
  }
  [[nodiscard]] Stiffness<double> stiffness(const Deformation<double>& /*deformation*/,
                                            const Input<double>& input,
                                            const State<double>& /*state*/) const noexcept {
    return {std::sqrt(input.share * fluid.bulk_modulus / fluid.reference_density),
            input.share * fluid.viscosity};
  }
};
static_assert(ConstitutiveLaw<Patchwork>);

/// Of velocity over h/dt, which disturbs what is at rest [-].
inline constexpr double disturbance = 1e-10;

/// Of everything, at random.
template <int D>
void disturb(Particles<D, D>& particles, double dt) {
  fill_at_random(particles.velocity, disturbance * Bar::spacing / dt);
  fill_at_random(particles.velocity_gradient, disturbance / dt);
}

/// How what points are disturbed by grows: its largest in the second `num_steps` steps over that in the
/// first, or 1e5, where waves are linear still.
template <int D>
[[nodiscard]] double growth_of(Particles<D, D> particles, const CartesianGrid<D>& grid,
                               const Stages<D, D>& stages, double dt, int num_steps) {
  constexpr double enough = 1e5;
  auto state = start(std::move(particles), grid, stages, {1});
  double first = disturbance / dt;
  double second = 0;
  for (int n = 0; n < 2 * num_steps; ++n) {
    step(state, stages, dt, {1});
    double& most = n < num_steps ? first : second;
    most = std::max(most, largest(state.particles.velocity_gradient));
    if (most > enough * disturbance / dt) return enough;
  }
  return second / first;
}

}  // namespace scree::mpm
