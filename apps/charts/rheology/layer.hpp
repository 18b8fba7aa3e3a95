#pragma once

#include <scree/grid.hpp>
#include <scree/rheology_stiff/implicit_viscosity.hpp>
#include <scree/rheology_stiff/viscous_operator.hpp>

#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <span>
#include <vector>

namespace scree::charts {

/// A layer 1 m deep on the rough base of a slope of 18 degrees, from rest: 51 nodes, of which the lowest is
/// held. Velocities have two components, across and along the slope; the first is zero.
class Layer {
 public:
  static constexpr Index num_cells = 50;
  static constexpr double spacing = 1.0 / num_cells;                         // [m]
  static constexpr double density = 1000;                                    // [kg/m^3]
  static constexpr double duration = 0.2;                                    // [s]
  static inline const double pull = 9.81 * std::sin(std::numbers::pi / 10);  // [m/s^2]

  /// @param viscosity of a cell at a shear rate [1/s]  @param largest_viscosity of any [Pa s]
  Layer(std::function<rheology::ViscosityAt(double)> viscosity, double largest_viscosity);

  [[nodiscard]] std::size_t num_values() const noexcept { return held_.size(); }
  [[nodiscard]] rheology::ViscousBody body() const noexcept { return {mass_, held_}; }
  [[nodiscard]] const CartesianGrid<1>& grid() const noexcept { return operator_.grid(); }
  [[nodiscard]] double explicit_step() const noexcept { return explicit_step_; }
  [[nodiscard]] rheology::ViscosityAt viscosity(double shear_rate) const { return viscosity_(shear_rate); }

  /// dv/dt by viscosity and gravity [m/s^2].
  void rate(std::span<const double> velocity, std::span<double> out);
  /// Gravity alone over a step.
  void fall(std::span<double> velocity, double dt) const noexcept;

 private:
  std::function<rheology::ViscosityAt(double)> viscosity_;
  rheology::ViscousOperator<1, 2> operator_;
  std::vector<double> mass_;        // of each node [kg]
  std::vector<std::uint8_t> held_;  // num_nodes x 2
  std::vector<double> weights_;     // of each cell [Pa s m]
  double explicit_step_;            // [s]
};

}  // namespace scree::charts
