// A layer of mud runs down a slope until it flows steadily, in a thousand times the step of an explicit
// scheme.
#include <scree/rheology_stiff/implicit_viscosity.hpp>

#include <cmath>
#include <cstdint>
#include <vector>

int main() {
  using Vector = scree::Vector<1>;
  constexpr double h = 0.02;         // [m]
  constexpr double density = 1000;   // [kg/m^3]
  constexpr double pull = 3;         // of gravity along the slope [m/s^2]
  constexpr double viscosity = 750;  // [Pa s]: an explicit step would be 2.7e-4 s
  const scree::CartesianGrid<1> depth{Vector{0.0}, Vector{h}, {50}, {false}};
  std::vector<double> mass(51, density * h);
  mass.front() = mass.back() = density * h / 2;
  std::vector<std::uint8_t> is_held(102, 0);
  is_held[0] = is_held[1] = 1;
  std::vector<double> velocity(102, 0.0);  // across and along the slope
  scree::rheology::ImplicitViscosity<1, 2> solver{depth};

  for (int step = 0; step < 100; ++step) {
    for (std::size_t i = 3; i < velocity.size(); i += 2) velocity[i] += 0.3 * pull;
    solver.advance(velocity, {mass, is_held}, std::vector<double>(50, viscosity), 0.3);
  }

  const double surface = density * pull / (2 * viscosity);
  return std::abs(velocity.back() - surface) < 1e-6 * surface ? 0 : 1;
}
