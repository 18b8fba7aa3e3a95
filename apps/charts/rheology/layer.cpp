#include "layer.hpp"

#include <utility>

namespace scree::charts {

Layer::Layer(std::function<rheology::ViscosityAt(double)> viscosity, double largest_viscosity)
    : viscosity_{std::move(viscosity)},
      operator_{CartesianGrid<1>{Vector<1>{0.0}, Vector<1>{spacing}, {num_cells}, {false}}},
      mass_(num_cells + 1, density * spacing),
      held_(2 * mass_.size(), 0),
      weights_(num_cells, largest_viscosity * spacing) {
  mass_.front() = mass_.back() = density * spacing / 2;
  held_[0] = held_[1] = 1;
  // The shortest wave of shear, which binds: the normal component does not move.  Eq. (R133)
  explicit_step_ = 2 / (4 * largest_viscosity / (density * spacing * spacing));
}

void Layer::rate(std::span<const double> velocity, std::span<double> out) {
  operator_.products(velocity, velocity, weights_);
  for (double& weight : weights_) weight = viscosity_(std::sqrt(weight)).viscosity * spacing;
  operator_.apply({}, weights_, velocity, out);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double fall = i % 2 == 1 ? pull : 0;
    out[i] = held_[i] != 0 ? 0 : fall - out[i] / mass_[i / 2];
  }
}

void Layer::fall(std::span<double> velocity, double dt) const noexcept {
  for (std::size_t i = 3; i < velocity.size(); i += 2) velocity[i] += dt * pull;
}

}  // namespace scree::charts
