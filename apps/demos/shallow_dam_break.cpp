// A dam breaks: water rushes through the gap and round three islands.
//
//   h_t + div(h v) = 0,   (h v)_t + div(h v v) + grad(g h^2/2) = 0                     Eqs. (T1), (T18)
//
// Dam and islands are cells that are not there: a mask over a plain lattice. Their sides reflect, and so do
// those of the basin. What walls must keep is checked: the amount of water and, where it is level, its rest.
// Energy may only be lost, in the bores.
#include "output.hpp"

#include <scree/box.hpp>
#include <scree/transport/grids/occupied_cells.hpp>
#include <scree/transport/laws/shallow_water.hpp>
#include <scree/transport/reconstructions/piecewise_linear.hpp>
#include <scree/transport/solver.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace scree;
using namespace scree::transport;

namespace {

constexpr double g = 9.81;            // [m/s^2]
constexpr double dx = 0.1;            // [m], of a basin of 20 m x 10 m
constexpr double depth_behind = 2;    // the dam [m]
constexpr double depth_before = 0.5;  // [m]

/// The dam, with a gap of 2 m, and three round islands.
bool is_wall(const Vector<2>& x) {
  const bool is_dam = std::abs(x[0] - 6) < 0.2 && std::abs(x[1] - 5) > 1;
  const auto is_island = [&](double centre_x, double centre_y, double radius) {
    return std::hypot(x[0] - centre_x, x[1] - centre_y) < radius;
  };
  return is_dam || is_island(9.5, 5, 0.8) || is_island(13, 2.5, 1.2) || is_island(13, 7.5, 1.2);
}

/// Water in a basin; the depth is zero where a wall stands.
struct Basin {
  Lattice<2> cells = box<2>({0, 0}, {20, 10}, {200, 100}).cells();
  OccupiedCells<2> grid{cells};
  std::vector<double> u;  // num_cells x (h, h v_x, h v_y), component fastest

  explicit Basin(double depth_left) {
    std::vector<double> masses;  // of a cell, here its area; none where there is no cell
    for (Index site = 0; site < cells.num_sites(); ++site) {
      const Vector<2> x = cells.position(cells.site(site));
      masses.push_back(is_wall(x) ? 0 : dx * dx);
      u.insert(u.end(), {is_wall(x) ? 0 : x[0] < 6 ? depth_left : depth_before, 0, 0});
    }
    grid.set_masses(masses);
  }

  void advance(double duration) {
    Solver solver{
        grid, ShallowWater<2>{g}, PiecewiseLinear{Minmod{}}, {.boundaries = everywhere(Reflecting{})}};
    solver.advance(u, duration);
  }
};

struct Totals {
  double water = 0;     // [m^3]
  double energy = 0;    // over the density [m^5/s^2]
  double momentum = 0;  // largest |h v| [m^2/s]
};

Totals totals_of(const Basin& basin) {
  Totals totals;
  for (auto u = basin.u.begin(); u != basin.u.end(); u += 3) {
    const double h = u[0];
    if (h == 0) continue;  // a wall
    const double momentum = std::hypot(u[1], u[2]);
    totals.water += dx * dx * h;
    totals.energy += dx * dx * (momentum * momentum / h + g * h * h) / 2;
    totals.momentum = std::max(totals.momentum, momentum);
  }
  return totals;
}

}  // namespace

int main(int argc, char** argv) {
  const auto folder = demo::folder_from(argc, argv);
  Basin rest{depth_before};
  rest.advance(1);
  bool is_right = totals_of(rest).momentum < 1e-12;  // at rest, but for round-off

  Basin basin{depth_behind};
  for (const char* name : {"shallow_dam_break_1.csv", "shallow_dam_break_2.csv", "shallow_dam_break_3.csv"}) {
    const Totals earlier = totals_of(basin);
    basin.advance(1);
    const Totals now = totals_of(basin);
    std::printf("water %.12g m^3  energy %.1f m^5/s^2\n", now.water, now.energy);
    demo::write_plane(folder / name, basin.cells, basin.u, 3);
    const bool has_all_water = std::abs(now.water - earlier.water) < 1e-12 * now.water;
    is_right = is_right && has_all_water && now.energy < earlier.energy;
  }
  return is_right ? 0 : 1;
}
