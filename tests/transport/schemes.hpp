#pragma once

#include "lines.hpp"

#include <scree/transport/integrators.hpp>
#include <scree/transport/reconstructions.hpp>

#include <stdexcept>
#include <string>

namespace scree::transport::test {

/// Calls visit(limiter) with the limiter that a table calls `name`; minmod with its theta, as "minmod 1.3".
template <class Visit>
decltype(auto) with_limiter(const std::string& name, Visit&& visit) {
  if (name == "centred") return visit(Centred{});
  if (name.starts_with("minmod ")) return visit(Minmod{std::stod(name.substr(7))});
  if (name == VanLeer::name) return visit(VanLeer{});
  if (name == VanAlbada::name) return visit(VanAlbada{});
  if (name == Superbee::name) return visit(Superbee{});
  throw std::runtime_error{"no limiter " + name};
}

/// The same with a reconstruction: a line with that limiter, or another one of that name.
template <class Visit>
decltype(auto) with_reconstruction(const std::string& name, Visit&& visit) {
  if (name == Cweno3::name) return visit(Cweno3{});
  return with_limiter(name, [&](const auto& limiter) { return visit(PiecewiseLinear{limiter}); });
}

inline Stages stages(const std::string& name) {
  if (name == SspRk2::name) return SspRk2{};
  if (name == SspRk3::name) return SspRk3{};
  if (name == ForwardEuler::name) return ForwardEuler{};
  throw std::runtime_error{"no integrator " + name};
}

/// A reconstruction that promises a CFL number of one: for tables that were made beyond what can be promised.
template <class R>
struct Unchecked : R {
  explicit Unchecked(const R& reconstruction) : R{reconstruction} {}
  [[nodiscard]] double promised_cfl() const noexcept { return 1; }
};

/// Advances by steps of full length and one of what is left, as the code behind the tables does. (A solver by
/// itself makes them equal; where a shock sits in its cell at the end depends on it.)
template <class Solver>
void advance_in_full_steps(Solver&& solver, std::vector<double>& u, double duration) {
  double remaining = duration;
  while (remaining > 0) {
    const double dt = std::min(solver.stable_time_step(u), remaining);
    solver.advance(u, dt);
    remaining -= dt;
    if (remaining < duration * 1e-12) remaining = 0;
  }
}

/// Advances by steps of a given length and one of what is left.
template <class Solver>
void advance_in_steps_of(double length, Solver&& solver, std::vector<double>& u, double duration) {
  double remaining = duration;
  while (remaining > duration * 1e-12) {
    const double dt = std::min(length, remaining);
    solver.advance(u, dt);
    remaining -= dt;
  }
}

/// Advances by steps that no solver would take or that it does not know, which nothing checks: of a length
/// that `length_of(bounds)` gives, bounds those of the state at hand, and one of what is left.
/// @param hold called after each stage with its states, to hold some of them  @return the number of steps
template <class Rates, class LengthOf, class Hold>
int advance_unchecked(Rates& rates, Stages stages, std::vector<double>& u, double duration,
                      LengthOf&& length_of, Hold&& hold) {
  using Storage = typename Rates::Storage;
  Storage now{rates.num_sites()};
  Storage stage{rates.num_sites()};
  Storage next{rates.num_sites()};
  now.gather(u, {});
  int num_steps = 0;
  for (double remaining = duration; remaining > duration * 1e-12; ++num_steps) {
    const double dt = std::min<double>(length_of(rates(now, next, 0)), remaining);
    for (std::size_t i = 0; i < now.all().size(); ++i) stage.all()[i] = now.all()[i] + dt * next.all()[i];
    hold(stage);
    for (const double kept : stages.kept.subspan(1)) {
      rates.advance_stage(stage, now, next, kept, dt, 0);
      std::swap(stage, next);
      hold(stage);
    }
    std::swap(now, stage);
    remaining -= dt;
  }
  now.scatter(u, {}, [](Index) { return true; });
  return num_steps;
}

/// The rule of the tables in the plane: dt = cfl dx over the largest speed along any axis, which is up to
/// twice the CFL number of a solver.
template <class Rates>
int advance_by_fastest_axis(Rates& rates, Stages stages, std::vector<double>& u, double duration,
                            double cfl) {
  const double dx = rates.problem().grid.width(0, 0);
  return advance_unchecked(
      rates, stages, u, duration, [&](const StepBounds& bounds) { return cfl * dx / bounds.speed; },
      [](const auto&) {});
}

}  // namespace scree::transport::test
