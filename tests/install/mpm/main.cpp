// A column of points falls freely; the law is the user's own.
#include <scree/mpm/seed.hpp>
#include <scree/mpm/step.hpp>

#include <array>
#include <cmath>
#include <string_view>

namespace {

/// Material that resists nothing.
struct Dust {
  static constexpr std::string_view name = "dust";
  template <class Real>
  struct Input {};
  static constexpr std::array<scree::InputColumn, 0> inputs{};
  template <class Real>
  struct State {};
  static constexpr std::array<scree::StateColumn, 0> states{};

  template <class Real>
  scree::Response<Real, State<Real>> update(const scree::Deformation<Real>& /*deformation*/,
                                            const Input<Real>& /*input*/, const State<Real>& /*old*/,
                                            Real /*dt*/) const noexcept {
    return {};
  }
  scree::Stiffness<double> stiffness(const scree::Deformation<double>& /*deformation*/,
                                     const Input<double>& /*input*/,
                                     const State<double>& /*state*/) const noexcept {
    return {0, 0};
  }
};
static_assert(scree::ConstitutiveLaw<Dust>);

}  // namespace

int main() {
  namespace mpm = scree::mpm;
  using Vector = scree::Vector<1>;
  constexpr double gravity = -9.81;
  constexpr double dt = 1e-3;
  const scree::CartesianGrid<1> grid{Vector{0.0}, Vector{0.1}, {20}, {false}};
  auto particles = mpm::seed_box<1, 1>(grid, Vector{1.0}, Vector{1.5}, {3}, 1000);
  mpm::Stages<1, 1> stages;
  stages.stress = std::make_unique<mpm::StressUpdateBy<1, 1, Dust>>(Dust{}, particles);
  stages.transfer = mpm::make_transfer<1, 1>(mpm::Quadratic{}, mpm::Apic{});
  stages.gravity = {gravity};
  auto state = mpm::start(std::move(particles), grid, stages, {1});

  for (int i = 0; i < 100; ++i) mpm::step(state, stages, dt, {1});

  const double speed = state.particles.velocity.component(0)[0];
  return std::abs(speed - 100 * dt * gravity) < 1e-12 ? 0 : 1;
}
