// A wall of your own: a film of oil that drags by k times the speed of what slides on it.
//
//   v(t) = v_inf (1 - exp(-k t/(rho H))),   v_inf = rho g H sin(a)/k                          Eqs.
//   (R160)-(R162)
//
// The law of a wall is a type with two functions: the traction at a speed, and the speed that is left after a
// step, by backward Euler, so that no step is too long for it. Any such type will do for walls of the mesh,
// for beds of any shape and for bodies that move.
#include "elastic.hpp"
#include "output.hpp"

#include <scree/mpm/boundaries/frictional.hpp>
#include <scree/mpm/seed.hpp>
#include <scree/mpm/step.hpp>

#include <cmath>
#include <cstdio>
#include <numbers>

using namespace scree;
using namespace scree::mpm;

namespace {

struct OilFilm {
  static constexpr std::string_view name = "oil_film";
  template <class Real>
  struct Input {};
  static constexpr std::array<InputColumn, 0> inputs{};

  double drag;  // k, viscosity over thickness of the film [Pa s/m]

  template <class Real>
  [[nodiscard]] Real traction(const Real&, const Real& speed, const Input<Real>&) const noexcept {
    return drag * speed;
  }
  /// v' of v' + mobility k v' = v, with mobility = dt over the mass on a unit of area.
  template <class Real>
  [[nodiscard]] Real slowed(const Real& speed, const WallContact<Real>& contact,
                            const Input<Real>&) const noexcept {
    return speed / (1 + contact.mobility * drag);
  }
};
static_assert(WallLaw<OilFilm>);

constexpr double g = 9.81;                             // [m/s^2]
constexpr double slope = 30 * std::numbers::pi / 180;  // a
constexpr double height = 0.25;                        // H [m]
constexpr double spacing = 0.125;                      // [m]
constexpr Threads threads{1};
constexpr demo::Elastic block{.bulk_modulus = 1e6, .shear_modulus = 1e6, .density = 1000};
constexpr OilFilm film{.drag = 500};

}  // namespace

int main(int argc, char** argv) {
  const CartesianGrid<2> grid{Vector<2>{0, 0}, Vector<2>{spacing, spacing}, {4, 4}, {true, false}};
  auto points = seed_box<2, 2>(grid, Vector<2>{0, 0}, Vector<2>{0.5, height}, {2, 2}, block.density);
  Stages<2, 2> stages;
  stages.stress = std::make_unique<StressUpdateBy<2, 2, demo::Elastic>>(block, points);
  stages.transfer = make_transfer<2, 2>(Linear{}, Apic{});
  stages.boundaries.push_back(make_frictional_wall<2>(film, {}, Hold::pushes_and_pulls, 1, Side::low));
  stages.gravity = {g * std::sin(slope), -g * std::cos(slope)};
  auto state = start(std::move(points), grid, stages, threads);

  const double delay = block.density * height / film.drag;  // rho H/k [s]
  const double terminal = delay * g * std::sin(slope);
  std::vector<demo::Column> slide{{"time", {}}, {"velocity", {}}, {"theory", {}}};
  double worst = 0;
  for (double time = 0; time < 6 * delay;) {
    const double dt = stable_time_step(grid, state.rates, {}).dt;
    step(state, stages, dt, threads);
    time += dt;
    double momentum = 0;
    double mass = 0;
    for (Index p = 0; p < state.particles.size(); ++p) {
      momentum += state.particles.mass.component(0)[p] * state.particles.velocity.component(0)[p];
      mass += state.particles.mass.component(0)[p];
    }
    slide[0].values.push_back(time);
    slide[1].values.push_back(momentum / mass);
    slide[2].values.push_back(terminal * (1 - std::exp(-time / delay)));
    worst = std::max(worst, std::abs(slide[1].values.back() - slide[2].values.back()) / terminal);
  }
  demo::write_table(demo::folder_from(argc, argv) / "own_wall.csv", slide);
  std::printf("the block comes to %.4f m/s, by theory %.4f m/s; it is off by %.2e of it at most\n",
              slide[1].values.back(), terminal, worst);
  // The foot of the block lags behind its middle: by shear it takes rho g H^2 sin(a)/(2 G) along, and rings.
  const double strain = block.density * g * std::sin(slope) * height / block.shear_modulus;
  const double ringing = strain * std::sqrt(block.shear_modulus / block.density) / terminal;
  return worst < 2 * ringing ? 0 : 1;
}
