// Grains that creep because their neighbours flow: a layer below its yield stress above a band that is
// sheared.
//
//   xi^2 g_yy = g,   xi = A s_a/sqrt(mu_s - mu),   g = gdot/mu,   g(0) = g_0,   g_y(H) = 0    Eqs. (R175),
//   (R176)
//
// A law that looks at one point, as mu(I) does, has this layer at rest. With the nonlocal fluidity the flow
// of the base is felt over the cooperativity length xi, some grains, and the longer the nearer the layer is
// to yield: g = g_0 cosh((H - y)/xi)/cosh(H/xi).
#include "output.hpp"

#include <scree/grid.hpp>
#include <scree/rheology/fluidity_grid.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace scree;
using namespace scree::rheology;

namespace {

constexpr NonlocalFluidity beads = typical<NonlocalFluidity>();
constexpr double grain_size = 1e-3;    // [m]
constexpr double height = 0.02;        // [m]
constexpr double pressure = 500;       // [Pa]
constexpr double base_fluidity = 1.0;  // [1/s]

std::vector<double> heights(Index num_cells) {
  std::vector<double> y;
  for (Index i = 0; i < num_cells; ++i) {
    y.push_back((static_cast<double>(i) + 0.5) * height / static_cast<double>(num_cells));
  }
  return y;
}

/// The fluidity of each cell [1/s].
std::vector<double> solve(double friction, Index num_cells) {
  const Vector<1> dy{height / static_cast<double>(num_cells)};
  const Lattice<1> cells = CartesianGrid<1>{Vector<1>{0.0}, dy, {num_cells}, {false}}.cells();
  const auto n = static_cast<std::size_t>(num_cells);
  FluidityGrid<1> layer{beads, cells, std::vector<bool>(n, true), {{{base_fluidity, std::nullopt}}}};
  const std::vector<double> mu(n, friction);
  const std::vector<double> p(n, pressure);
  const std::vector<double> sizes(n, grain_size);
  std::vector<double> g(n);
  layer.solve_steady({mu, p, sizes}, g);
  return g;
}

std::vector<double> exact(double friction, Index num_cells) {
  std::vector<double> g;
  const double xi = beads.cooperativity_length(friction, grain_size);
  for (const double y : heights(num_cells)) {
    g.push_back(base_fluidity * std::cosh((height - y) / xi) / std::cosh(height / xi));
  }
  return g;
}

double error(double friction, Index num_cells) {
  const auto g = solve(friction, num_cells);
  const auto wanted = exact(friction, num_cells);
  double worst = 0;
  for (std::size_t i = 0; i < g.size(); ++i) worst = std::max(worst, std::abs(g[i] - wanted[i]));
  return worst;
}

/// Counts what does not hold of one layer.
int check(double friction) {
  const double coarse = error(friction, 100);
  const double fine = error(friction, 200);
  const double order = std::log2(coarse / fine);
  const double xi = beads.cooperativity_length(friction, grain_size);
  std::printf("mu_s - mu = %.3f  xi = %.2f grains  error %.2e, %.2e on half the cells  order %.2f\n",
              beads.mu_s - friction, xi / grain_size, coarse, fine, order);
  // In units of g_0 (dy/xi)^2: an eighth from the half cell at the base, where a quarter of g'' is missed,
  // and 1/(24 e) at most from the length of the decay. The first cell is part of dy/xi nearer, and so the
  // order.
  const double width = height / 200 / xi;
  const bool is_close = fine < (1.0 / 8 + 1.0 / 24) * base_fluidity * width * width;
  const bool is_at_rest_locally = beads.local_fluidity(friction, pressure, grain_size) == 0;
  return is_close && std::abs(order - 2) < 2 * width && is_at_rest_locally ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const auto folder = demo::folder_from(argc, argv);
  int faults = 0;
  std::vector<demo::Column> layers{{"y", heights(100)}};
  for (const double distance : {0.005, 0.02, 0.08}) {  // mu_s - mu
    const double friction = beads.mu_s - distance;
    faults += check(friction);
    layers.push_back({"g_" + std::to_string(distance), solve(friction, 100)});
    layers.push_back({"exact_" + std::to_string(distance), exact(friction, 100)});
  }
  demo::write_table(folder / "creeping_layer.csv", layers);
  return faults;
}
