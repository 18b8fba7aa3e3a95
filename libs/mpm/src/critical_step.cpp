#include "instances.hpp"
#include "point_text.hpp"
#include "stencil.hpp"

#include <scree/mpm/critical_step.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <sstream>
#include <variant>
#include <vector>

namespace scree::mpm {

namespace {

/// What of a transfer decides how a wave grows.
struct Passing {
  bool has_affine;
  bool has_affine_gradient;
  double share;    ///< of the nodes' increment [-]
  int xpic_order;  ///< of the filter of velocities; 0: there is none
};

[[nodiscard]] Passing passing_of(const AnyTransfer& transfer, int xpic_order) {
  return std::visit(
      [xpic_order](const auto& rule) {
        require(
            xpic_order == 0 || (!rule.has_affine && rule.increment_share() == 1),
            "filtered velocities: their critical step is known of pic_flip with increment_share = 1 only");
        return Passing{rule.has_affine, rule.has_affine_gradient, rule.increment_share(), xpic_order};
      },
      transfer);
}

/// The terms of the sum (M173): that of sound over dt^2 [1/s^2], that of viscosity over dt [1/s].
struct WaveRates {
  double sound = 0;
  double viscosity = 0;
};

[[nodiscard]] WaveRates wave_rates(double wave_speed, double kinematic_viscosity, double spacing) noexcept {
  const double sound = wave_speed / spacing;
  return {sound * sound, 8.0 / 3 * kinematic_viscosity / (spacing * spacing)};
}

/// The step with which terms of these rates make the sum [s].
[[nodiscard]] double step_of(double sum, const WaveRates& rates) noexcept {
  const double viscosity = rates.viscosity / sum;
  return 2 / (viscosity + std::sqrt(viscosity * viscosity + 4 * rates.sound / sum));
}

/// The shorter one, and no number if one of them is none.
[[nodiscard]] double shorter_step(double one, double other) noexcept {
  return one < other || std::isnan(one) ? one : other;
}

/// Points that lie alike in their stencils, to a thousandth of a spacing.
struct SharedPlace {
  double xi = 0;    ///< their mean place, by mass [spacings]
  double mass = 0;  ///< of all [kg]
  WaveRates rates;  ///< their mean, by mass
};

/// Where points lie, so that each wave takes a look at some thousand places at most. Means over points that
/// lie alike to the bit are theirs; others' are off by the square of the width, not more.
class SharedPlaces {
 public:
  void add(double xi, double mass, const WaveRates& rates) {
    const auto bin = static_cast<std::size_t>(std::max(xi, 0.0) * per_spacing);
    SharedPlace& place = places_[std::min(bin, places_.size() - 1)];
    place.mass += mass;
    const double part = mass / place.mass;
    place.xi += (xi - place.xi) * part;
    place.rates.sound += (rates.sound - place.rates.sound) * part;
    place.rates.viscosity += (rates.viscosity - place.rates.viscosity) * part;
  }
  [[nodiscard]] std::vector<SharedPlace> in_use() const {
    std::vector<SharedPlace> used;
    std::ranges::copy_if(places_, std::back_inserter(used),
                         [](const SharedPlace& one) { return one.mass > 0; });
    return used;
  }

 private:
  static constexpr std::size_t per_spacing = 1024;
  static constexpr std::size_t longest = 4;  // support [nodes]
  std::vector<SharedPlace> places_ = std::vector<SharedPlace>(longest * per_spacing);
};

/// Of a wave on the nodes: means over points, by mass, of what they see of it.  Eqs. (M174), (M199)
struct Seen {
  double velocity = 0;   ///< |sum_i w_ip e_i|^2
  double gradient = 0;   ///< |sum_i b_ip e_i|^2, the gradient times the spacing
  double passed_on = 0;  ///< of it by points that pass their gradient on
  WaveRates stiffness;   ///< the gradient's squares times the rates
};

template <class S>
[[nodiscard]] Seen seen_of(const S& shape, const Passing& passing, std::span<const SharedPlace> places,
                           double wave_number) {
  constexpr std::size_t support = S::support;
  std::array<Vector<2>, support> wave;
  for (std::size_t i = 0; i < support; ++i) {
    const double phase = wave_number * static_cast<double>(i);
    wave[i] = {std::cos(phase), std::sin(phase)};
  }
  Seen sum;
  double total = 0;
  for (const auto& [xi, mass, rates] : places) {
    const auto weights = shape.weights(xi);
    const auto gradients = passing.has_affine_gradient ? shape.affine(xi) : shape.gradients(xi);
    Vector<2> velocity = Vector<2>::Zero();
    Vector<2> gradient = Vector<2>::Zero();
    Vector<2> lever = Vector<2>::Zero();
    for (std::size_t i = 0; i < support; ++i) {
      velocity += weights[i] * wave[i];
      gradient += gradients[i] * wave[i];
      lever += weights[i] * (static_cast<double>(i) - xi) * wave[i];
    }
    const double strain = mass * gradient.squaredNorm();
    total += mass;
    sum.velocity += mass * velocity.squaredNorm();
    sum.gradient += strain;
    if (passing.has_affine) sum.passed_on += mass * lever.dot(gradient);
    sum.stiffness.sound += strain * rates.sound;
    sum.stiffness.viscosity += strain * rates.viscosity;
  }
  return {sum.velocity / total,
          sum.gradient / total,
          sum.passed_on / total,
          {sum.stiffness.sound / total, sum.stiffness.viscosity / total}};
}

/// The stiffness s with which a wave turns round by each step, -1 times itself.  Eqs. (M174), (M182)
[[nodiscard]] double turning_stiffness(const Seen& seen, const Passing& passing, Order order) noexcept {
  if (passing.xpic_order > 0) {
    const double twice = 2 - std::pow(1 - seen.velocity, passing.xpic_order);
    return 2 * twice / (order == Order::usl ? twice - seen.velocity : seen.velocity);
  }
  const double share = passing.share;
  const double kept = (1 + share) * (1 + seen.passed_on) + (1 - share) * seen.velocity;
  const double felt =
      order == Order::usl ? 1 + share - share * seen.velocity : seen.velocity + (1 + share) * seen.passed_on;
  return 2 * kept / felt;
}

/// Calls visit(seen, turning stiffness) for each wave along an axis.
template <class Visit>
void for_each_wave(std::span<const SharedPlace> places, const AnyShape& any_shape, const Passing& passing,
                   Order order, const Visit& visit) {
  constexpr int num_waves = 32;
  std::visit(
      [&](const auto& shape) {
        for (int n = 1; n <= num_waves; ++n) {
          const Seen seen = seen_of(shape, passing, places, n * std::numbers::pi / num_waves);
          visit(seen, turning_stiffness(seen, passing, order));
        }
      },
      any_shape);
}

/// Where points with mass lie along an axis.
/// @param rates of a point, by its index
template <int D, int V, class RatesOf>
[[nodiscard]] std::vector<SharedPlace> places_along(int axis, const Particles<D, V>& particles,
                                                    const CartesianGrid<D>& grid, const AnyShape& shape,
                                                    const RatesOf& rates) {
  const double shift = std::visit([](const auto& s) { return s.shift; }, shape);
  SharedPlaces places;
  for (Index p = 0; p < particles.size(); ++p) {
    const double mass = particles.mass.component(0)[p];
    if (!(mass > 0)) continue;
    const double x = particles.position.component(axis)[p];
    if (!std::isfinite(x)) throw InputError{point_text(particles, p) + " has no finite position"};
    places.add(detail::place_of(x, grid.origin()[axis], 1 / grid.spacing()[axis], shift).xi, mass, rates(p));
  }
  return places.in_use();
}

/// The limit that asks for more of the sum (M173) at that step, the same along each axis; and the acoustic
/// one where its rate is no number.
[[nodiscard]] Limit larger_share(const Rates& rates, double dt) noexcept {
  const auto [sound, viscosity] = wave_rates(rates.wave_speed, rates.kinematic_viscosity, 1);
  return sound * dt > viscosity || !std::isfinite(sound) ? Limit::acoustic : Limit::viscous;
}

/// The point that has the largest rate of waves, its own motion left out: the first whose rate is no number,
/// or none if no rate is larger than zero.
template <int D, int V>
[[nodiscard]] std::optional<Index> fastest_point(const Particles<D, V>& particles,
                                                 const StressUpdate<D, V>& stress, Limit limit) {
  std::optional<Index> found;
  double largest = 0;
  for (Index p = 0; p < particles.size(); ++p) {
    if (!(particles.mass.component(0)[p] > 0)) continue;
    const BlockStiffness stiffness = stress.stiffness(particles, p, p + 1);
    const double rate = limit == Limit::viscous ? stiffness.kinematic_viscosity : stiffness.wave_speed;
    if (!std::isfinite(rate)) return p;
    if (rate > largest) {
      largest = rate;
      found = p;
    }
  }
  return found;
}

}  // namespace

template <int D, int V>
Vector<D> critical_sums(const Particles<D, V>& particles, const CartesianGrid<D>& grid, const AnyShape& shape,
                        const AnyTransfer& transfer, Order order, int xpic_order) {
  const Passing passing = passing_of(transfer, xpic_order);
  Vector<D> sums = Vector<D>::Constant(std::numeric_limits<double>::infinity());
  for (int axis = 0; axis < D; ++axis) {
    const auto places =
        places_along(axis, particles, grid, shape, [](Index /*point*/) { return WaveRates{}; });
    require(!places.empty(), "critical_sums: there must be a point with mass");
    for_each_wave(places, shape, passing, order, [&](const Seen& seen, double stiffness) {
      sums[axis] = std::min(sums[axis], stiffness / seen.gradient);
    });
  }
  return sums;
}

template <int D>
double critical_step(const Vector<D>& sums, const CartesianGrid<D>& grid, const Rates& rates) noexcept {
  double dt = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < D; ++axis) {
    const WaveRates along = wave_rates(rates.wave_speed, rates.kinematic_viscosity, grid.spacing()[axis]);
    dt = shorter_step(step_of(sums[axis], along), dt);
  }
  return dt;
}

template <int D, int V>
double unstable_step(const Particles<D, V>& particles, const StressUpdate<D, V>& stress,
                     const CartesianGrid<D>& grid, const AnyShape& shape, const AnyTransfer& transfer,
                     Order order, int xpic_order) {
  const Passing passing = passing_of(transfer, xpic_order);
  double dt = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < D; ++axis) {
    const auto rates = [&](Index p) {
      const BlockStiffness here = stress.stiffness(particles, p, p + 1);
      return wave_rates(here.wave_speed, here.kinematic_viscosity, grid.spacing()[axis]);
    };
    const auto places = places_along(axis, particles, grid, shape, rates);
    if (places.empty()) return dt;
    for_each_wave(places, shape, passing, order, [&](const Seen& seen, double stiffness) {
      dt = shorter_step(step_of(stiffness, seen.stiffness), dt);
    });
  }
  return dt;
}

template <int D, int V>
void require_stable(const State<D, V>& state, const Stages<D, V>& stages, const Vector<D>& sums, double dt) {
  const CartesianGrid<D>& grid = state.nodes.grid();
  const double critical = critical_step(sums, grid, state.rates);
  constexpr double slack = 1 + 1e-9;  // both are rounded
  if (dt <= critical * slack) return;
  const Limit limit = larger_share(state.rates, critical);
  const auto point = fastest_point(state.particles, *stages.stress, limit);
  std::ostringstream message;
  message << "a step of " << dt << " s must not exceed the critical one, " << critical
          << " s, beyond which waves grow; it comes from the " << limit_names[static_cast<std::size_t>(limit)]
          << " limit";
  if (point) message << " of " << point_text(state.particles, *point);
  throw InputError{message.str()};
}

#define SCREE_INSTANCE(D, V)                                                                                \
  template Vector<D> critical_sums(const Particles<D, V>&, const CartesianGrid<D>&, const AnyShape&,        \
                                   const AnyTransfer&, Order, int);                                         \
  template double unstable_step(const Particles<D, V>&, const StressUpdate<D, V>&, const CartesianGrid<D>&, \
                                const AnyShape&, const AnyTransfer&, Order, int);                           \
  template void require_stable(const State<D, V>&, const Stages<D, V>&, const Vector<D>&, double);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE
template double critical_step(const Vector<1>&, const CartesianGrid<1>&, const Rates&) noexcept;
template double critical_step(const Vector<2>&, const CartesianGrid<2>&, const Rates&) noexcept;
template double critical_step(const Vector<3>&, const CartesianGrid<3>&, const Rates&) noexcept;

}  // namespace scree::mpm
