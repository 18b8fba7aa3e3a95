#include "../every_scheme.hpp"
#include "../problems.hpp"
#include "lines.hpp"

#include <scree/transport/grids/cartesian.hpp>
#include <scree/transport/laws/burgers.hpp>

#include <cmath>
#include <numbers>

namespace scree::charts {
namespace {

using std::numbers::pi;
using BurgersCase = Case<transport::Cartesian<1>, transport::Burgers>;

/// Where the value at `distance` in [0, pi] came from, in the frame of the mean speed: the root of
/// y + t sin y = distance on the branch that no shock has taken, by bisection.
double foot_of(double distance, double time) {
  double low = 0;
  double high = time > 1 ? std::acos(-1 / time) : pi;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = (low + high) / 2;
    (middle + time * std::sin(middle) < distance ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// Antiderivative of the entropy solution from 0.5 + sin x: the Hopf-Lax potential, Phi_0 + t u^2/2 along
/// characteristics. The shock stands where both sides have the same one, at a distance of pi.
double potential(double x, double time) {
  const double distance = x - 0.5 * time;
  const double period = 2 * pi * std::floor(distance / (2 * pi));
  const double within = distance - period;
  const double foot = within <= pi ? foot_of(within, time) : 2 * pi - foot_of(2 * pi - within, time);
  const double u = 0.5 + std::sin(foot);
  return 0.5 * (foot + period) - std::cos(foot) + time * u * u / 2;
}

/// The problem on cells moved to the right by parts of a cell.
std::vector<BurgersCase> places_of(Index n, double time, int count) {
  std::vector<BurgersCase> places;
  for (int place = 0; place < count; ++place) {
    const double shift = 2 * pi / static_cast<double>(n) * place / count;
    const Lattice<1> cells = line(n, shift, 2 * pi + shift, true);
    places.push_back({cells,
                      {},
                      {},
                      averages(cells, [](double x) { return potential(x, 0); }),
                      averages(cells, [&](double x) { return potential(x, time); }),
                      time});
  }
  return places;
}

std::vector<Record> burgers(const std::string& problem, double time, int num_places, const Extent& extent) {
  std::vector<Record> records;
  for (const Index n : doublings(40, 6, extent)) {
    std::ranges::copy(run_every_scheme(problem, n, places_of(n, time, num_places), extent.effort),
                      std::back_inserter(records));
  }
  return records;
}

}  // namespace

std::vector<Record> burgers_smooth(const Extent& extent) {
  return burgers("burgers_smooth", 0.5, 1, extent);
}

std::vector<Record> burgers_shock(const Extent& extent) {
  return burgers("burgers_shock", 2, 4, extent);
}

}  // namespace scree::charts
