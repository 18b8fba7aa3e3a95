// A grid of your own: a ring in polar cells, which the library has never heard of.
//   u_t + div(v u) = 0,   v = (-y, x)                                               Eqs. (T1), (T12)
// Any type that tells its cells and faces is a FaceGrid, and every scheme for cells of any form works on it.
// The cells follow the turning flow, so that nothing crosses the walls.
#include <scree/transport/laws/advection.hpp>
#include <scree/transport/solver.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

using namespace scree;
using namespace scree::transport;

namespace {
constexpr double turn = 2 * std::numbers::pi;  // [s], at one radian per second

/// The ring 1/2 < r < 1 in rows of cells with straight sides. What its public members tell is all it needs.
class PolarGrid {
 public:
  static constexpr int dimension = 2;

  PolarGrid(Index rows, Index angles) {
    const double step = turn / static_cast<double>(angles);
    const auto along = [&](double j) { return Vector<2>{std::cos(step * j), std::sin(step * j)}; };
    for (Index cell = 0; cell < rows * angles; ++cell) {  // row by row
      const Index row = cell / angles;
      const auto j = static_cast<double>(cell % angles);
      const double a = 0.5 + 0.5 * static_cast<double>(row) / static_cast<double>(rows);
      const double b = a + 0.5 / static_cast<double>(rows);
      const Vector<2> outward = along(j + 0.5);
      const double chord = std::cos(step / 2);      // between corners at r = 1: its distance,
      const double width = 2 * std::sin(step / 2);  // and its length
      volumes_.push_back(0.5 * std::sin(step) * (b * b - a * a));
      centres_.emplace_back((a + (b - a) * (a + 2 * b) / (3 * (a + b))) * chord * outward);  // of a trapezoid
      const Vector<2> side = along(j + 1);
      const Index next = (cell + 1) % angles == 0 ? cell + 1 - angles : cell + 1;
      const bool is_last = cell + angles >= rows * angles;
      const auto add = [&](Index to, int rim, const Vector<2>& normal, double area, const Vector<2>& at) {
        faces_.push_back({cell, to, rim, normal, area, at, at, at});
      };
      add(next, -1, Vector<2>{-side[1], side[0]}, b - a, 0.5 * (a + b) * side);
      add(is_last ? no_site : cell + angles, is_last ? 1 : -1, outward, b * width, b * chord * outward);
      if (cell < angles) add(no_site, 0, -outward, a * width, a * chord * outward);
    }
    for (GridFace<2>& face : faces_) {
      face.from_owner -= centre(face.owner);
      if (face.neighbour != no_site) face.from_neighbour -= centre(face.neighbour);
    }
  }

  [[nodiscard]] Index num_cells() const noexcept { return static_cast<Index>(volumes_.size()); }
  [[nodiscard]] Index num_faces() const noexcept { return static_cast<Index>(faces_.size()); }
  [[nodiscard]] double volume(Index cell) const noexcept { return volumes_.data()[cell]; }
  [[nodiscard]] Vector<2> centre(Index cell) const noexcept { return centres_.data()[cell]; }
  [[nodiscard]] GridFace<2> face(Index i) const noexcept { return faces_.data()[i]; }
  [[nodiscard]] static int num_boundaries() noexcept { return 2; }
  [[nodiscard]] static std::string_view boundary_name(int i) noexcept { return i == 0 ? "inner" : "outer"; }

 private:
  std::vector<double> volumes_;
  std::vector<Vector<2>> centres_;
  std::vector<GridFace<2>> faces_;
};
static_assert(FaceGrid<PolarGrid>);

/// The law of a face: the velocity differs from place to place.
struct Rotation {
  static Advection<2> at(const GridFace<2>& f) noexcept { return {Vector<2>{-f.centre[1], f.centre[0]}}; }
};

/// Turns a smooth hill by a quarter. @return the L1 error [m^2]; infinity if mass or bounds were lost
double error_after_a_quarter(Index rows) {
  const PolarGrid grid{rows, 12 * rows};
  std::vector<double> u;
  for (Index i = 0; i < grid.num_cells(); ++i) u.push_back(std::exp(2 * grid.centre(i)[0] - 2));
  const SolverOptions<PolarGrid, 1> walls{.boundaries = {{"inner", ZeroFlux{}}, {"outer", ZeroFlux{}}}};
  Solver solver{grid, Rotation{}, CellGradient{SmoothCubic{}, 1}, walls};
  const int steps = solver.advance(u, turn / 4).substeps;
  double error = 0, gained = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    const auto cell = static_cast<Index>(i);
    const double start = std::exp(2 * grid.centre(cell)[0] - 2);
    const double turned = std::exp(2 * grid.centre(cell)[1] - 2);  // what was at (y, -x) is at (x, y)
    error += grid.volume(cell) * std::abs(u[i] - turned);
    gained += grid.volume(cell) * (u[i] - start);
  }
  const auto [low, high] = std::ranges::minmax(u);
  std::printf("%td rows  %4d steps  L1 error %.2e  u from %.4f to %.4f  mass gained %.0e\n", rows, steps,
              error, low, high, gained);
  return low >= std::exp(-4) && high <= 1 && std::abs(gained) < 1e-13 ? error : HUGE_VAL;
}

}  // namespace

int main() {
  const double order = std::log2(error_after_a_quarter(10) / error_after_a_quarter(20));
  std::printf("order %.2f\n", order);
  return order > 1.8 ? 0 : 1;
}
