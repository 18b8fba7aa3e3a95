// The rotating wave of Kurganov, Petrova and Popov: a law of the user's own, whose flux is not convex.
//
//   u_t + (sin u)_x + (cos u)_y = 0,   u = 14 pi/4 in the unit disk, pi/4 outside            Eq. (T1)
//
// A law is two lambdas: its flux, and a bound of the wave speed for all states between two. "Between" matters
// where f is not convex: from pi/4 to 14 pi/4 the wave runs through crests of |f'| that neither end shows.
// The law is solved twice, with the bound over the whole interval, and with the speeds at its two ends alone.
#include "output.hpp"

#include <scree/box.hpp>
#include <scree/transport/laws/user_law.hpp>
#include <scree/transport/reconstructions/piecewise_linear.hpp>
#include <scree/transport/solver.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

using namespace scree;
using namespace scree::transport;

namespace {

using std::numbers::pi;

constexpr double inside = 14 * pi / 4;
constexpr double outside = pi / 4;
constexpr Index num_cells = 200;  // along each axis

/// f.n = n_x sin u + n_y cos u, along a unit normal n.
constexpr auto flux = [](double u, const Vector<2>& n) { return n[0] * std::sin(u) + n[1] * std::cos(u); };

/// |d(f.n)/du| = |cos(u + angle)|
double angle_of(const Vector<2>& n) {
  return std::atan2(n[1], n[0]);
}

/// Wrong: as if f were convex.
constexpr auto speed_at_ends = [](double left, double right, const Vector<2>& n) {
  const double angle = angle_of(n);
  return larger(std::abs(std::cos(left + angle)), std::abs(std::cos(right + angle)));  // passes a NaN on
};

/// Right: 1 if there is a crest of |cos| between both, which are pi apart; else |cos| is largest at an end.
constexpr auto speed_between = [](double left, double right, const Vector<2>& n) {
  const double angle = angle_of(n);
  const bool has_crest = std::floor((left + angle) / pi) != std::floor((right + angle) / pi);
  return has_crest ? larger(1, 0 * (left + right)) : speed_at_ends(left, right, n);
};

struct Range {
  double low;
  double high;
};

/// Solves with one of the two speeds, and draws. @return the range of the result
template <class Speed>
Range solve(Speed speed, const std::filesystem::path& file) {
  const Lattice<2> cells = box<2>({-2, -2.5}, {2, 1.5}, {num_cells, num_cells}).cells();
  std::vector<double> u;
  for (Index site = 0; site < cells.num_sites(); ++site) {
    u.push_back(cells.position(cells.site(site)).norm() < 1 ? inside : outside);
  }
  Solver solver{Cartesian{cells},
                make_law<1, 2>(flux, speed),
                PiecewiseLinear{Minmod{}},
                {.boundaries = everywhere(Outflow{})}};

  const Advance done = solver.advance(u, 1);

  demo::write_plane(file, cells, u);
  const auto [low, high] = std::ranges::minmax(u);
  std::printf("%s: %d steps, u from %.6f to %.6f\n", file.stem().c_str(), done.substeps, low, high);
  return {low, high};
}

}  // namespace

int main(int argc, char** argv) {
  const auto folder = demo::folder_from(argc, argv);
  std::printf("bounds of the exact solution: %.6f to %.6f\n", outside, inside);
  const Range right = solve(speed_between, folder / "kpp_right.csv");
  const Range wrong = solve(speed_at_ends, folder / "kpp_wrong.csv");
  // The scheme keeps the bounds to round-off, a few units in the last place of u in each of some hundred
  // steps. Without the crests it leaves them by far.
  const bool is_bounded = right.low > outside - 1e-12 && right.high < inside + 1e-12;
  return is_bounded && wrong.low < outside - 0.05 && wrong.high > inside + 0.05 ? 0 : 1;
}
