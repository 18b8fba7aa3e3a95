// The start-up of a layer by every method there is.
#include "layer.hpp"
#include "problems.hpp"

#include <scree/rheology/yield_stress.hpp>
#include <scree/rheology_stiff/rkl2.hpp>
#include <scree/rheology_stiff/stiff_integrator.hpp>

#include <algorithm>
#include <iterator>
#include <numbers>

namespace scree::charts {

namespace {

using namespace rheology;

constexpr double affordable = 2e6;  // explicit steps of one run

/// Measures one way to advance a layer. `advance` takes velocities to the end, and returns the applications.
template <class Advance>
Run measure(Run named, const std::vector<double>& reference, const Effort& effort, Advance&& advance) {
  std::vector<double> v;
  named.cpu_seconds = best_cpu_seconds(
      [&] {
        v.assign(reference.size(), 0.0);
        named.applications = advance(v);
      },
      effort);
  named.error = relative_l1(v, reference);
  return named;
}

double by_explicit_steps(Layer& layer, long steps, std::vector<double>& v) {
  std::vector<double> rate(v.size());
  const double dt = Layer::duration / static_cast<double>(steps);
  for (long n = 0; n < steps; ++n) {
    layer.rate(v, rate);
    for (std::size_t i = 0; i < v.size(); ++i) v[i] += dt * rate[i];
  }
  return static_cast<double>(steps);
}

double by_rkl2(Layer& layer, long steps, std::vector<double>& v) {
  Rkl2 scheme{v.size()};
  const double dt = Layer::duration / static_cast<double>(steps);
  const int stages = rkl2_stages(dt, layer.explicit_step());
  const auto rate = [&](std::span<const double> u, std::span<double> out) { layer.rate(u, out); };
  for (long n = 0; n < steps; ++n) scheme.advance(v, dt, stages, rate);
  return static_cast<double>(steps) * stages;
}

/// Solves of backward Euler, and what they took.
class Solves {
 public:
  explicit Solves(const Layer& layer)
      : layer_{layer}, solver_{layer.grid()}, law_{[&layer](double rate, Index /*cell*/) {
          return layer.viscosity(rate);
        }} {}

  void advance(std::vector<double>& v, double dt) {
    layer_.fall(v, dt);
    products += solver_.advance(v, layer_.body(), law_, dt).products;
  }

  double products = 0;

 private:
  const Layer& layer_;
  ImplicitViscosity<1, 2> solver_;
  ViscosityLaw law_;
};

double by_implicit_steps(const Layer& layer, long steps, std::vector<double>& v) {
  Solves solves{layer};
  const double dt = Layer::duration / static_cast<double>(steps);
  for (long n = 0; n < steps; ++n) solves.advance(v, dt);
  return solves.products;
}

/// Two solves a step, of second order and L-stable: Eq. (R146).
double by_two_solves(const Layer& layer, long steps, std::vector<double>& v) {
  const double gamma = 1 - 1 / std::numbers::sqrt2;
  Solves solves{layer};
  const double dt = Layer::duration / static_cast<double>(steps);
  std::vector<double> before;
  for (long n = 0; n < steps; ++n) {
    before = v;
    solves.advance(v, gamma * dt);
    for (std::size_t i = 0; i < v.size(); ++i) v[i] = before[i] + (1 / gamma - 1) * (v[i] - before[i]);
    solves.advance(v, gamma * dt);
  }
  return solves.products;
}

/// Every method at steps that halve, as far as they are stable and can be paid for.
std::vector<Run> run_methods(const Run& named, Layer& layer, const std::vector<double>& reference,
                             const Extent& extent) {
  std::vector<Run> runs;
  const double limit = Layer::duration / layer.explicit_step();
  const auto add = [&](const char* method, long steps, auto&& advance) {
    Run run = named;
    run.method = method;
    run.steps = steps;
    run.ratio = limit / static_cast<double>(steps);
    runs.push_back(measure(run, reference, extent.effort, advance));
  };
  const auto fewest = static_cast<long>(limit) + 1;
  const long most = extent.is_quick ? 128 : 1024;
  const long times_fewest = extent.is_quick ? 2 : 8;
  for (long steps = fewest; steps <= std::max(times_fewest * fewest, most); steps *= 2) {
    if (static_cast<double>(steps) > affordable) break;
    add("explicit", steps, [&](std::vector<double>& v) { return by_explicit_steps(layer, steps, v); });
  }
  for (long steps = 1; steps <= most; steps *= 2) {
    const double stages = 2 * std::sqrt(limit / static_cast<double>(steps));
    if (stages + 3 > largest_rkl2) continue;
    add("rkl2", steps, [&](std::vector<double>& v) { return by_rkl2(layer, steps, v); });
  }
  for (long steps = 1; steps <= most; steps *= 2) {
    add("implicit", steps, [&](std::vector<double>& v) { return by_implicit_steps(layer, steps, v); });
    add("two_solves", steps, [&](std::vector<double>& v) { return by_two_solves(layer, steps, v); });
  }
  return runs;
}

/// Velocities of a viscous layer at the end, exact in time: the modes of its nodes, sin((m + 1/2) pi y),
/// decay at the rates of Eq. (R133).
std::vector<double> exact_start_up(double viscosity) {
  constexpr auto n = static_cast<std::size_t>(Layer::num_cells);
  const auto height = [](std::size_t i) { return static_cast<double>(i) * Layer::spacing; };
  const auto steady = [&](double y) { return Layer::density * Layer::pull / viscosity * (y - y * y / 2); };
  std::vector<double> v(2 * (n + 1), 0.0);
  for (std::size_t i = 0; i <= n; ++i) v[2 * i + 1] = steady(height(i));
  for (std::size_t m = 0; m < n; ++m) {
    const double k = (static_cast<double>(m) + 0.5) * std::numbers::pi;
    const double sine = std::sin(k * Layer::spacing / 2);
    const double decay = 4 * viscosity / Layer::density * std::pow(sine / Layer::spacing, 2);
    double amplitude = 0;
    for (std::size_t i = 1; i <= n; ++i) {
      amplitude += (i == n ? 1 : 2) * Layer::spacing * std::sin(k * height(i)) * steady(height(i));
    }
    amplitude *= std::exp(-decay * Layer::duration);
    for (std::size_t i = 1; i <= n; ++i) v[2 * i + 1] -= amplitude * std::sin(k * height(i));
  }
  return v;
}

/// Velocities of any layer at the end, by backward differentiation to ten digits.
std::vector<double> integrated_start_up(Layer& layer) {
  std::vector<double> v(layer.num_values(), 0.0);
  const auto rate = [&](double /*time*/, RateForm::Values u, std::span<double> out) { layer.rate(u, out); };
  StiffIntegrator oracle{v.size(), {"layer", rate}, {1e-10, 1e-12}};
  oracle.advance(v, 0, Layer::duration);
  return v;
}

}  // namespace

std::vector<Run> newtonian_layer(const Extent& extent) {
  std::vector<Run> runs;
  std::vector<double> viscosities{1, 10, 100, 1e3, 1e4};  // [Pa s]
  if (extent.is_quick) viscosities = {1e3};
  for (const double mu : viscosities) {
    Layer layer{[mu](double /*rate*/) { return ViscosityAt{mu}; }, mu};
    const Run named{.problem = "newtonian_layer", .parameter = mu};
    std::ranges::copy(run_methods(named, layer, exact_start_up(mu), extent), std::back_inserter(runs));
  }
  return runs;
}

std::vector<Run> bingham_layer(const Extent& extent) {
  constexpr double viscosity = 750;      // [Pa s]
  constexpr double yield_stress = 1000;  // [Pa]
  std::vector<Run> runs;
  std::vector<double> times{0.1, 1, 10, 100, 1e3};  // m [s]
  if (extent.is_quick) times = {1};
  for (const double m : times) {
    const auto bingham = [m](double rate) {  // Eqs. (R8), (R9)
      const double mu_y = papanastasiou_viscosity(rate, yield_stress, m);
      const double slope = rate > 0 ? (yield_stress * m * std::exp(-m * rate) - mu_y) / rate : 0;
      return ViscosityAt{viscosity + mu_y, slope};
    };
    Layer layer{bingham, viscosity + yield_stress * m};
    const Run named{.problem = "bingham_layer", .parameter = m};
    std::ranges::copy(run_methods(named, layer, integrated_start_up(layer), extent),
                      std::back_inserter(runs));
  }
  return runs;
}

}  // namespace scree::charts
