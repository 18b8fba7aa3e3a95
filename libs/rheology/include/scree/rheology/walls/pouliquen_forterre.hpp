#pragma once

#include <scree/rheology/concepts.hpp>

#include <array>
#include <cmath>
#include <string_view>
#include <type_traits>

namespace scree::rheology {

/// A rough bed under a layer of dry grains, by the depth and the depth-averaged speed of the layer: thin
/// layers stop on slopes where thick ones flow, and what has stopped takes a steeper slope to start again.
///
/// With Fr = v/sqrt(g h): friction grows with speed above Fr = beta, falls from its value at the start to
/// that at the stop below it.
/// @see Eqs. (R167)-(R172), from Pouliquen & Forterre (2002), \cite pouliquen2002, with the fit of Forterre
/// & Pouliquen (2003), \cite forterre2003
struct PouliquenForterre {
  static constexpr std::string_view name = "pouliquen_forterre";
  static constexpr std::string_view summary = "rough bed under a layer that stops when it gets thin";

  template <class Real>
  struct Input {
    Real depth;       ///< h, of the layer, normal to the bed [m], not negative
    Real grain_size;  ///< arithmetic mean s_a [m], positive
  };
  static constexpr std::array<InputColumn, 2> inputs{{{"depth", "m", 0.1}, {"grain_size", "m", 1e-3}}};

  double mu_1;             ///< friction at which a layer of any depth stops [-]
  double mu_2;             ///< friction of the thinnest layer that stops [-]
  double mu_3;             ///< friction at which a deep layer starts [-]
  double beta;             ///< Froude number of the slowest steady flow [-]
  double length_per_size;  ///< L/s_a: depth over which the bed is felt, in grain sizes [-]
  double weakening;        ///< exponent by which friction falls from start to stop [-]
  double gravity;          ///< g [m/s^2]

  static constexpr std::array<LawParameter<PouliquenForterre>, 7> parameters{{
      {"mu_1", "-", "friction at which a deep layer stops", &PouliquenForterre::mu_1, Bound::positive, 0.382},
      {.name = "mu_2",
       .unit = "-",
       .meaning = "friction at which the thinnest layer stops",
       .member = &PouliquenForterre::mu_2,
       .bound = Bound::positive,
       .typical = 0.644,
       .exceeds = &PouliquenForterre::mu_1},
      {.name = "mu_3",
       .unit = "-",
       .meaning = "friction at which a deep layer starts",
       .member = &PouliquenForterre::mu_3,
       .bound = Bound::positive,
       .typical = 0.415,
       .exceeds = &PouliquenForterre::mu_1},
      {"beta", "-", "Froude number of the slowest steady flow", &PouliquenForterre::beta, Bound::positive,
       0.136},
      {"length_per_size", "-", "depth over which the bed is felt, in grain sizes",
       &PouliquenForterre::length_per_size, Bound::positive, 1.65},
      {"weakening", "-", "exponent of the fall of friction from start to stop", &PouliquenForterre::weakening,
       Bound::positive, 1e-3, 1},
      {"gravity", "m/s^2", "by which the Froude number is made", &PouliquenForterre::gravity, Bound::positive,
       9.81},
  }};

  /// Depth below which a flow down a slope of this tangent stops [m]; mu_1 < tangent < mu_2.  Eq. (R168)
  [[nodiscard]] double stopping_depth(double tangent, double grain_size) const noexcept {
    return length_per_size * grain_size * (mu_2 - tangent) / (tangent - mu_1);
  }

  /// Friction at which a layer stops [-].  Eq. (R167)
  template <class Real>
  [[nodiscard]] Real friction_at_stop(const Input<Real>& input) const noexcept {
    const Real length = length_per_size * input.grain_size;
    return mu_1 + (mu_2 - mu_1) * length / (length + input.depth);
  }

  /// Friction at which a layer at rest starts [-].  Eq. (R169)
  template <class Real>
  [[nodiscard]] Real friction_at_start(const Input<Real>& input) const noexcept {
    return friction_at_stop(input) + (mu_3 - mu_1);
  }

  /// Largest shear traction [Pa].  Eqs. (R169)-(R171)
  /// @param pressure p [Pa]  @param speed v, the depth average [m/s]
  template <class Real>
  [[nodiscard]] Real traction(const Real& pressure, const Real& speed,
                              const Input<Real>& input) const noexcept {
    using std::pow;
    const Real slowest = slowest_speed(input);
    const Real start = friction_at_start(input);
    const Real falling = start - (mu_3 - mu_1) * pow(speed / slowest, Real(weakening));
    const Real rising = mu_1 + (mu_2 - mu_1) * speed / (speed + half_way_speed(input));
    return pressure * select(speed <= 0.0, start, select(speed < slowest, falling, rising));
  }

  /// Speed at the end of a step [m/s].  Eqs. (R171), (R172)  @param speed without friction [m/s]
  template <class Real>
  [[nodiscard]] Real slowed(const Real& speed, const WallContact<Real>& contact,
                            const Input<Real>& input) const noexcept {
    const Real impulse = contact.mobility * contact.pressure;
    const Real held = impulse * friction_at_start(input);
    const Real slowest = slowest_speed(input);
    const Real rising = slowed_by_rising(speed - mu_1 * impulse, (mu_2 - mu_1) * impulse, input);
    if (!in_any_lane(rising < slowest)) return select(speed <= held, Real(0.0), rising);
    const Real falling =
        slowest * root_of_falling((speed - held) / slowest, (mu_3 - mu_1) * impulse / slowest);
    return select(speed <= held, Real(0.0), select(rising < slowest, falling, rising));
  }

 private:
  /// Speed at Fr = beta [m/s].
  template <class Real>
  [[nodiscard]] Real slowest_speed(const Input<Real>& input) const noexcept {
    using std::sqrt;
    return beta * sqrt(gravity * input.depth);
  }

  /// Speed at which friction is half way from mu_1 to mu_2 [m/s].  Eq. (R170)
  template <class Real>
  [[nodiscard]] Real half_way_speed(const Input<Real>& input) const noexcept {
    return slowest_speed(input) * input.depth / (length_per_size * input.grain_size);
  }

  /// The root v > 0 of v + rise v/(v + V) = rest; both forms are free of cancellation.  Eq. (R171)
  template <class Real>
  [[nodiscard]] Real slowed_by_rising(const Real& rest, const Real& rise,
                                      const Input<Real>& input) const noexcept {
    using std::sqrt;
    const Real half_way = half_way_speed(input);
    const Real b = half_way + rise - rest;
    const Real root = sqrt(b * b + 4.0 * half_way * rest);
    return select(b < 0.0, 0.5 * (root - b), 2.0 * half_way * rest / (b + root));
  }

  /// The larger root of x - fall x^weakening = rest > 0, by Newton's method from above: the left side is
  /// convex, so that the iterates fall to the root until rounding stops them.  Eq. (R172)
  template <class Real>
  [[nodiscard]] Real root_of_falling(const Real& rest, const Real& fall) const noexcept {
    using std::pow;
    constexpr int max_iterations = 100;  // [-], above what the smallest positive rest takes
    Real x = rest + fall;
    for (int i = 0; i < max_iterations; ++i) {
      const Real fallen = fall * pow(x, Real(weakening));
      const Real next = (rest + (1 - weakening) * fallen) / (1.0 - weakening * fallen / x);
      const bool is_settled = !in_any_lane(next < x);
      x = next;
      if (is_settled) break;
    }
    return x;
  }
};
static_assert(DescribedWall<PouliquenForterre>);

}  // namespace scree::rheology
