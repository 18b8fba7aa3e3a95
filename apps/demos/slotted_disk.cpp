// The slotted disk: one turn of a solid body, which a perfect scheme would leave as it was.
//
//   u_t + div(v u) = 0,   v = (1/2 - y, x - 1/2)                                     Eqs. (T1), (T12)
//
// The velocity differs from place to place, so the law does: `at(face)` returns the law of a face. Edges and
// slot are what numerical diffusion wears away; how much of them is left after a turn is up to the limiter.
#include "output.hpp"

#include <scree/box.hpp>
#include <scree/transport/laws/advection.hpp>
#include <scree/transport/limiters.hpp>
#include <scree/transport/reconstructions/piecewise_linear.hpp>
#include <scree/transport/solver.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <numeric>

using namespace scree;
using namespace scree::transport;

namespace {

constexpr Index num_cells = 100;  // along each axis of the unit square
constexpr double dx = 1.0 / num_cells;
constexpr double turn = 2 * std::numbers::pi;  // [s]

/// A turn about the centre of the square, at one radian per second.
struct Rotation {
  Lattice<2> cells;

  /// The speed along an axis does not change along it, so that at a cell is that at its faces.
  [[nodiscard]] Advection<2> at(const Face& face) const noexcept {
    const Vector<2> x = cells.position(cells.site(face.owner));
    return {Vector<2>{0.5 - x[1], x[0] - 0.5}};
  }
};
static_assert(ConservationLaw<Rotation, 2>);

/// A disk with a slot cut into it from below.
bool is_in_disk(double x, double y) {
  return std::hypot(x - 0.5, y - 0.75) < 0.15 && !(std::abs(x - 0.5) < 0.025 && y < 0.85);
}

/// Mean of the disk over each cell, from 8 x 8 points.
std::vector<double> disk_on(const Lattice<2>& cells) {
  constexpr int points = 8;
  std::vector<double> u;
  for (Index site = 0; site < cells.num_sites(); ++site) {
    const Vector<2> low = cells.position(cells.site(site)) - cells.spacing / 2;
    int inside = 0;
    for (int i = 0; i < points; ++i) {
      for (int j = 0; j < points; ++j) {
        inside += is_in_disk(low[0] + dx * (i + 0.5) / points, low[1] + dx * (j + 0.5) / points);
      }
    }
    u.push_back(inside / static_cast<double>(points * points));
  }
  return u;
}

/// Turns the disk once and draws what is left. @return the error over the area of the disk [-]; infinity if a
/// value has left [0, 1], or mass was lost
template <Limiter L>
double error_of(const L& limiter, const std::filesystem::path& file, const Lattice<2>& cells,
                const std::vector<double>& disk) {
  std::vector<double> u = disk;
  Solver solver{Cartesian{cells}, Rotation{cells}, PiecewiseLinear{limiter}};  // walls unless told otherwise

  const Advance done = solver.advance(u, turn);

  demo::write_plane(file, cells, u);
  const double area = std::reduce(disk.begin(), disk.end());
  double error = 0;
  for (std::size_t i = 0; i < u.size(); ++i) error += std::abs(u[i] - disk[i]) / area;
  const auto [low, high] = std::ranges::minmax(u);
  const double lost = std::abs(1 - std::reduce(u.begin(), u.end()) / area);
  std::printf("%-22s %4d steps  error %.3f  u from %.0e to %.4f  lost %.0e\n", file.stem().c_str(),
              done.substeps, error, low, high, lost);
  return low > -1e-13 && high < 1 + 1e-13 && lost < 1e-12 ? error : HUGE_VAL;  // round-off
}

}  // namespace

int main(int argc, char** argv) {
  const auto folder = demo::folder_from(argc, argv);
  const Lattice<2> cells = box<2>({0, 0}, {1, 1}, {num_cells, num_cells}).cells();
  const std::vector<double> disk = disk_on(cells);
  demo::write_plane(folder / "slotted_disk_start.csv", cells, disk);
  const double minmod = error_of(Minmod{}, folder / "slotted_disk_minmod.csv", cells, disk);
  const double van_leer = error_of(VanLeer{}, folder / "slotted_disk_van_leer.csv", cells, disk);
  const double mc = error_of(Minmod{2}, folder / "slotted_disk_mc.csv", cells, disk);
  const double superbee = error_of(Superbee{}, folder / "slotted_disk_superbee.csv", cells, disk);
  return superbee < mc && mc < van_leer && van_leer < minmod && minmod < 1 ? 0 : 1;
}
