// A law of your own: grains that flow as Bagnold found, tau = rho l^2 gdot^2, down a rough slope.
//   u(y) = (2/3) (g sin a)^(1/2) (H^(3/2) - (H - y)^(3/2))/l
//
// A law is a type with the members below: it reads no column of the points (`Input`), remembers nothing
// (`State`), and answers the rate of deformation with a stress. A layer over its depth needs one dimension.
#include "output.hpp"

#include <scree/mpm/geostatic.hpp>
#include <scree/mpm/seed.hpp>
#include <scree/mpm/step.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

using namespace scree;
using namespace scree::mpm;

namespace {

struct Bagnold {
  static constexpr std::string_view name = "bagnold";
  template <class Real>
  struct Input {};
  static constexpr std::array<InputColumn, 0> inputs{};
  template <class Real>
  struct State {};
  static constexpr std::array<StateColumn, 0> states{};

  double length;        // l [m]
  double bulk_modulus;  // [Pa]
  double density;       // without pressure [kg/m^3]

  /// The shear rate, (2 D':D')^(1/2), from the rate of deformation without its volume change [1/s].
  template <class Real>
  [[nodiscard]] Real viscosity(const Deformation<Real>& deformation) const noexcept {
    return density * length * length * shear_rate(deformation.velocity_gradient);
  }
  template <class Real>
  [[nodiscard]] Response<Real, State<Real>> update(const Deformation<Real>& deformation, const Input<Real>&,
                                                   const State<Real>&, Real) const noexcept {
    const Real pressure = bulk_modulus * (deformation.density / density - 1);
    const Tensor<Real> shear = deviator(symmetric_part(deformation.velocity_gradient));
    return {2 * viscosity(deformation) * shear - isotropic(pressure), {}};
  }
  /// What bounds the step: the speed of sound, and the viscosity.
  [[nodiscard]] Stiffness<double> stiffness(const Deformation<double>& deformation, const Input<double>&,
                                            const State<double>&) const noexcept {
    return {std::sqrt(bulk_modulus / density), viscosity(deformation)};
  }
};
static_assert(ConstitutiveLaw<Bagnold>);

constexpr Bagnold grains{.length = 0.05, .bulk_modulus = 1e6, .density = 1500};
constexpr double g = 9.81;                             // [m/s^2]
constexpr double slope = 25 * std::numbers::pi / 180;  // a
constexpr double depth = 0.1;                          // H [m]
constexpr Index num_cells = 40;
constexpr Threads threads{1};

double theory(double y) {
  const double scale = 2.0 / 3 * std::sqrt(g * std::sin(slope)) / grains.length;
  return scale * (std::pow(depth, 1.5) - std::pow(depth - y, 1.5));
}

}  // namespace

int main(int argc, char** argv) {
  const CartesianGrid<1> grid{Vector<1>{0.0}, Vector<1>{depth / num_cells}, {num_cells + 2}, {false}};
  auto layer = seed_box<1, 2>(grid, Vector<1>{0.0}, Vector<1>{depth}, {2}, grains.density);
  Stages<1, 2> stages;
  stages.stress = std::make_unique<StressUpdateBy<1, 2, Bagnold>>(grains, layer);
  stages.transfer = make_transfer<1, 2>(Linear{}, Apic{});
  stages.boundaries.push_back(make_wall<1>(NoSlip{}, 0, Side::low));
  stages.gravity = {-g * std::cos(slope), g * std::sin(slope)};  // across the layer, and down the slope
  set_geostatic(layer, *stages.stress, 0, depth, g * std::cos(slope));
  auto state = start(std::move(layer), grid, stages, threads);
  for (double time = 0, dt = 0; time < 1; time += dt) {  // [s], ten times that in which it would fall so fast
    dt = stable_time_step(grid, state.rates, {}).dt;
    step(state, stages, dt, threads);
  }
  // Bounds of what cells leave out and what compression adds, as shares of the speed of the surface.
  const double mesh = 0.0547 / std::pow(num_cells, 1.5) + 1.0 / (32 * num_cells * num_cells);
  const double compression = 0.15 * grains.density * g * std::cos(slope) * depth / grains.bulk_modulus;
  std::vector<demo::Column> profile{{"y", {}}, {"velocity", {}}, {"theory", {}}};
  double worst = 0;
  for (Index p = 0; p < state.particles.size(); ++p) {
    if (!(state.particles.mass.component(0)[p] > 0)) continue;  // only fills up a block
    const double y = state.particles.position.component(0)[p];
    profile[0].values.push_back(y);
    profile[1].values.push_back(state.particles.velocity.component(1)[p]);
    profile[2].values.push_back(theory(y));
    const double ahead = (profile[1].values.back() - theory(y)) / theory(depth);
    worst = std::max({worst, -ahead / mesh, ahead / compression});
  }
  demo::write_table(demo::folder_from(argc, argv) / "own_law.csv", profile);
  std::printf("speeds are off by %.2f of what cells and compression leave them, at most\n", worst);
  return worst < 1 ? 0 : 1;
}
