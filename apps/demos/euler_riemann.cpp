// Four gases meet: the 2D Riemann problem of gas dynamics, configuration 3.
//
//   u_t + f(u)_x + g(u)_y = 0   for density, momentum and energy of an ideal gas    Eqs. (T1), (T15)
//
// Each quarter of the unit square starts with a gas of its own, at rest or in motion, such that every pair of
// neighbours meets in one shock. The four shocks collide, and a jet curls up along the diagonal.
// Nothing is tuned: these are the library's default settings.
#include "output.hpp"

#include <scree/box.hpp>
#include <scree/transport/laws/euler.hpp>
#include <scree/transport/solver.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <thread>

using namespace scree;
using namespace scree::transport;

namespace {

constexpr Index num_cells = 240;  // along each axis
constexpr double dx = 1.0 / num_cells;
constexpr double end_time = 0.3;
constexpr double inflow_speed = 1.206;
constexpr double density_low = 0.138;    // of the quarter that flows along the diagonal
constexpr double density_side = 0.5323;  // of its two neighbours, which flow along one axis
constexpr double density_rest = 1.5;

/// The gas of a quarter: it flows along each axis on whose lower half it starts.
Euler<2>::State gas_at(const Euler<2>& euler, const Vector<2>& x) {
  const bool is_left = x[0] < 0.5;
  const bool is_below = x[1] < 0.5;
  const Vector<2> velocity{is_left ? inflow_speed : 0, is_below ? inflow_speed : 0};
  if (is_left && is_below) return euler.state(density_low, velocity, 0.029);
  if (is_left || is_below) return euler.state(density_side, velocity, 0.3);
  return euler.state(density_rest, velocity, 1.5);
}

/// The mass at the end in closed form: what was there, and what has come in through the left and the lower
/// side, along which a shock travels that keeps mass: s = [rho v]/[rho].
double exact_mass() {
  const double shock_speed = inflow_speed * density_low / (density_side - density_low);
  const double shift = shock_speed * end_time / 2;  // on average over time
  const double inflow = inflow_speed * (density_side * (0.5 + shift) + density_low * (0.5 - shift));
  return (density_rest + 2 * density_side + density_low) / 4 + 2 * end_time * inflow;
}

}  // namespace

int main(int argc, char** argv) {
  const auto folder = demo::folder_from(argc, argv);
  const Lattice<2> cells = box<2>({0, 0}, {1, 1}, {num_cells, num_cells}).cells();
  const Euler<2> euler;
  std::vector<double> u;  // num_cells^2 x 4 components, component fastest
  for (Index site = 0; site < cells.num_sites(); ++site) {
    const auto state = gas_at(euler, cells.position(cells.site(site)));
    u.insert(u.end(), state.begin(), state.end());
  }

  const Threads threads{static_cast<int>(std::thread::hardware_concurrency())};  // any number: the same bits
  // Nothing said about the scheme: the usual one, slopes of density, velocity and pressure, kept positive.
  Solver solver{Cartesian{cells}, euler, {.threads = threads, .boundaries = everywhere(Outflow{})}};
  const Advance done = solver.advance(u, end_time);
  demo::write_plane(folder / "euler_riemann.csv", cells, u, 4);

  const auto density = [&](Index i, Index j) { return u[static_cast<std::size_t>(4 * cells.index({i, j}))]; };
  double mass = 0;
  double lowest = density(0, 0);
  double highest = lowest;
  double asymmetry = 0;  // across the diagonal x = y
  for (Index i = 0; i < num_cells; ++i) {
    for (Index j = 0; j < num_cells; ++j) {
      mass += dx * dx * density(i, j);
      lowest = std::min(lowest, density(i, j));
      highest = std::max(highest, density(i, j));
      asymmetry = std::max(asymmetry, std::abs(density(i, j) - density(j, i)));
    }
  }
  std::printf("%d steps  density from %.4f to %.4f  mass %.6f, exact %.6f  asymmetry %.0e\n", done.substeps,
              lowest, highest, mass, exact_mass(), asymmetry);
  // The four states have four digits, and so has the exact mass. Round-off grows along the unstable slip
  // lines.
  return std::abs(mass - exact_mass()) < 1e-4 && lowest > 0 && asymmetry < 1e-8 ? 0 : 1;
}
