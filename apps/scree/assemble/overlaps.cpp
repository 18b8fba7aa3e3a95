#include "scree/assemble/overlaps.hpp"

#include "scree/assemble/ground.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace scree::app {

namespace {

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
  double deepest = 1e-6 * grid.spacing().minCoeff();  // bodies that touch overlap by round-off
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

template void require_apart(const Scene&, const CartesianGrid<2>&, const mpm::AnySurface<2>&);
template void require_apart(const Scene&, const CartesianGrid<3>&, const mpm::AnySurface<3>&);

}  // namespace scree::app
