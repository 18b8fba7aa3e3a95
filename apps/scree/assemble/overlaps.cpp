#include "scree/assemble/overlaps.hpp"

#include "scree/assemble/ground.hpp"
#include "scree/scene/axes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace scree::app {

namespace {

/// Of a spacing: places closer than this are one. It exceeds the round-off of a distance, some 1e-16 of the
/// coordinates, where these are below some 1e9 spacings, and is far below what material feels.
constexpr double same_place = 1e-6;

/// What is solid, as it is at the start.
struct Solid {
  std::string name;
  bool is_bounded;
  std::vector<double> distances;  // of the nodes of the mesh, negative inside [m]
};

[[nodiscard]] bool is_bounded(const BodyScene& body) {
  if (const auto* ball = std::get_if<BallScene>(&body.surface)) return !ball->is_hollow;
  return std::holds_alternative<TriangleMesh>(body.surface);
}

template <int D>
[[nodiscard]] std::vector<double> distances_of(const CartesianGrid<D>& grid,
                                               const mpm::AnySurface<D>& surface) {
  const Lattice<D> nodes = grid.nodes();
  std::vector<double> distances;
  distances.reserve(static_cast<std::size_t>(nodes.num_sites()));
  for (Index n = 0; n < nodes.num_sites(); ++n) {
    distances.push_back(surface(nodes.position(nodes.site(n))).distance);
  }
  return distances;
}

template <int D>
void require_apart(const Solid& a, const Solid& b, const CartesianGrid<D>& grid) {
  if (!a.is_bounded && !b.is_bounded) return;
  double deepest = same_place * grid.spacing().minCoeff();  // bodies that touch overlap by round-off
  std::optional<std::size_t> worst;
  for (std::size_t n = 0; n < a.distances.size(); ++n) {
    const double depth = std::min(-a.distances[n], -b.distances[n]);
    if (!(depth > deepest)) continue;
    deepest = depth;
    worst = n;
  }
  if (!worst) return;
  const Lattice<D> nodes = grid.nodes();
  const Vector<D> x = nodes.position(nodes.site(static_cast<Index>(*worst)));
  throw InputError{fmt::format(
      "{} and {} overlap: the place ({:.6g}) m is {:.6g} m deep in the one and {:.6g} m in the other; move "
      "them apart, or say may_overlap = true of the body",
      a.name, b.name, fmt::join(x.begin(), x.end(), ", "), -a.distances[*worst], -b.distances[*worst])};
}

/// How far from a point its shape function is not zero [spacings].
[[nodiscard]] double reach_of(const mpm::AnyShape& any_shape) noexcept {
  return std::visit(
      []<class Shape>(const Shape& shape) {
        if constexpr (std::is_same_v<Shape, mpm::Gimp>) return 1 + shape.half_width();
        return static_cast<double>(Shape::support) / 2;
      },
      any_shape);
}

[[nodiscard]] bool lets_slip(const WallScene& wall) noexcept {
  const auto* plain = std::get_if<mpm::AnyWall>(&wall);
  return plain != nullptr && std::holds_alternative<mpm::Slip>(*plain);
}

/// Up to which height over a wall material feels it [spacings]; 0 of none.
[[nodiscard]] double felt_height(const WallScene& wall, const mpm::AnyShape& shape) noexcept {
  if (std::holds_alternative<OpenEnd>(wall)) return 0;
  return reach_of(shape) - (lets_slip(wall) ? 1 : 0);
}

}  // namespace

template <int D>
void require_apart(const Scene& scene, const CartesianGrid<D>& grid, const mpm::AnySurface<D>& ground) {
  const auto is_asked = [](const BodyScene& body) { return is_bounded(body) && !body.may_overlap; };
  if (std::ranges::none_of(scene.bodies, is_asked)) return;
  std::vector<Solid> solids;
  if (ground) solids.push_back({"[terrain]", false, distances_of(grid, ground)});
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const BodyScene& body = scene.bodies[i];
    if (body.may_overlap) continue;
    solids.push_back(
        {fmt::format("[[bodies]] {}", i + 1), is_bounded(body), distances_of(grid, surface_of<D>(body))});
    for (std::size_t other = 0; other + 1 < solids.size(); ++other) {
      require_apart(solids.back(), solids[other], grid);
    }
  }
}

template <int D>
std::string wall_under_ground_warning(const Scene& scene, const CartesianGrid<D>& grid,
                                      const mpm::AnySurface<D>& ground) {
  const int up = normal_component(D);
  const auto axis = static_cast<std::size_t>(up);
  if (!ground || scene.axes[axis].is_periodic) return {};
  const WallScene& wall = scene.axes[axis].low;
  const double felt = felt_height(wall, scene.shape) * grid.spacing()[up];
  const double rounding = same_place * grid.spacing()[up];  // as of ground through the nodes of the wall
  Lattice<D> nodes = grid.nodes();
  nodes.count[axis] = 1;
  double lowest = felt - rounding;
  std::optional<Vector<D>> place;
  for (Index n = 0; n < nodes.num_sites(); ++n) {
    const Vector<D> x = nodes.position(nodes.site(n));
    const mpm::FromSurface<D> seen = ground(x);
    const double height = -seen.distance / seen.normal[up];
    if (!(seen.normal[up] > 0 && -rounding <= height && height < lowest)) continue;
    lowest = height;
    place = x;
  }
  if (!place) return {};
  const char* effect =
      lets_slip(wall) ? "bears part of its load on it without friction" : "may be held or rubbed by it, too";
  return fmt::format(
      "[terrain] lies {:.4g} m above [boundaries] {}_low at ({:.6g}) m, and what lies less than {:.4g} m "
      "above this wall {}: make the end \"open\", which ground closes, or the ground higher",
      std::max(lowest, 0.0), axis_names(D)[axis], fmt::join(place->begin(), place->end(), ", "), felt,
      effect);
}

template void require_apart(const Scene&, const CartesianGrid<2>&, const mpm::AnySurface<2>&);
template void require_apart(const Scene&, const CartesianGrid<3>&, const mpm::AnySurface<3>&);
template std::string wall_under_ground_warning(const Scene&, const CartesianGrid<1>&,
                                               const mpm::AnySurface<1>&);
template std::string wall_under_ground_warning(const Scene&, const CartesianGrid<2>&,
                                               const mpm::AnySurface<2>&);
template std::string wall_under_ground_warning(const Scene&, const CartesianGrid<3>&,
                                               const mpm::AnySurface<3>&);

}  // namespace scree::app
