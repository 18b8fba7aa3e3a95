#include "triangle_tree.hpp"

#include <scree/mpm/terrain/triangle_surface.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <numeric>
#include <string>

namespace scree::mpm {

namespace detail {

namespace {

constexpr Index triangles_per_box = 4;  // few enough that looking at all costs as much as at two more boxes

[[nodiscard]] double squared_distance(const Vector<3>& low, const Vector<3>& high,
                                      const Vector<3>& x) noexcept {
  return (x - x.cwiseMax(low).cwiseMin(high)).squaredNorm();
}

[[nodiscard]] double angle_at(const Vector<3>& corner, const Vector<3>& next, const Vector<3>& last) {
  const Vector<3> a = (next - corner).normalized();
  const Vector<3> b = (last - corner).normalized();
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

[[nodiscard]] std::string name_of(std::size_t triangle) {
  return "triangle " + std::to_string(triangle);
}

}  // namespace

NearestPlace nearest_on_triangle(const std::array<Vector<3>, 3>& corners, const Vector<3>& x) noexcept {
  // Behind both edges of a corner it is the nearest; beside an edge, outside of it, that edge; else the face.
  std::array<double, 3> along{};  // of each edge, 0 at its first corner and 1 at its last
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector<3> edge = corners[(i + 1) % 3] - corners[i];
    along[i] = (x - corners[i]).dot(edge) / edge.squaredNorm();
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (along[i] <= 0 && along[(i + 2) % 3] >= 1) return {corners[i], 4 + static_cast<int>(i)};
  }
  const Vector<3> normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector<3> edge = corners[(i + 1) % 3] - corners[i];
    const bool is_outside = (x - corners[i]).dot(edge.cross(normal)) >= 0;
    if (is_outside && 0 < along[i] && along[i] < 1) {
      return {corners[i] + along[i] * edge, 1 + static_cast<int>(i)};
    }
  }
  return {x - (x - corners[0]).dot(normal) * normal, 0};
}

TriangleTree::TriangleTree(TriangleMesh mesh) : mesh_{std::move(mesh)} {
  require(!mesh_.triangles.empty(), "TriangleSurface: has no triangle");
  const auto num_vertices = static_cast<Index>(mesh_.vertices.size());
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    for (const Index vertex : mesh_.triangles[t]) {
      require(0 <= vertex && vertex < num_vertices, "TriangleSurface: " + name_of(t) + " names vertex " +
                                                        std::to_string(vertex) + " of " +
                                                        std::to_string(num_vertices));
    }
    const auto [a, b, c] = corners(static_cast<Index>(t));
    const double doubled_area = (b - a).cross(c - a).norm();
    require(doubled_area > 0 && std::isfinite(doubled_area),
            "TriangleSurface: " + name_of(t) + " has no area");
  }
  find_normals();
  build();
}

std::array<Vector<3>, 3> TriangleTree::corners(Index triangle) const noexcept {
  const auto& numbers = mesh_.triangles[static_cast<std::size_t>(triangle)];
  return {mesh_.vertices[static_cast<std::size_t>(numbers[0])],
          mesh_.vertices[static_cast<std::size_t>(numbers[1])],
          mesh_.vertices[static_cast<std::size_t>(numbers[2])]};
}

void TriangleTree::find_normals() {
  std::map<std::pair<Index, Index>, std::size_t> triangle_of;  // directed edge to triangle
  std::vector<Vector<3>> of_vertex(mesh_.vertices.size(), Vector<3>::Zero());
  normals_.resize(mesh_.triangles.size());
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    const auto& numbers = mesh_.triangles[t];
    const auto places = corners(static_cast<Index>(t));
    const Vector<3> normal = (places[1] - places[0]).cross(places[2] - places[0]).normalized();
    normals_[t].fill(normal);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [found, is_new] = triangle_of.try_emplace({numbers[i], numbers[(i + 1) % 3]}, t);
      require(is_new,
              "TriangleSurface: " + name_of(found->second) + " and " + name_of(t) +
                  " have an edge in the same direction: they face different ways, or the edge has more than "
                  "two triangles");
      of_vertex[static_cast<std::size_t>(numbers[i])] +=
          angle_at(places[i], places[(i + 1) % 3], places[(i + 2) % 3]) * normal;
    }
  }
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    const auto& numbers = mesh_.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) {
      const auto beyond = triangle_of.find({numbers[(i + 1) % 3], numbers[i]});
      if (beyond != triangle_of.end()) normals_[t][1 + i] = normals_[t][0] + normals_[beyond->second][0];
      normals_[t][4 + i] = of_vertex[static_cast<std::size_t>(numbers[i])];
    }
  }
}

void TriangleTree::build() {
  order_.resize(mesh_.triangles.size());
  std::iota(order_.begin(), order_.end(), Index{0});
  boxes_.push_back({.begin = 0, .end = static_cast<Index>(order_.size()), .first_half = -1});
  for (std::size_t box = 0; box < boxes_.size(); ++box) halve(static_cast<Index>(box));
}

void TriangleTree::halve(Index number) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box box = boxes_[static_cast<std::size_t>(number)];
  box.low.fill(infinity);
  box.high.fill(-infinity);
  for (Index i = box.begin; i < box.end; ++i) {
    for (const Vector<3>& corner : corners(order_[static_cast<std::size_t>(i)])) {
      box.low = box.low.cwiseMin(corner);
      box.high = box.high.cwiseMax(corner);
    }
  }
  if (box.end - box.begin > triangles_per_box) {
    int longest = 0;
    (box.high - box.low).maxCoeff(&longest);
    const Index middle = (box.begin + box.end) / 2;
    const auto place = [&](Index triangle) {
      const auto [a, b, c] = corners(triangle);
      return a[longest] + b[longest] + c[longest];
    };
    std::nth_element(order_.begin() + box.begin, order_.begin() + middle, order_.begin() + box.end,
                     [&](Index a, Index b) {
                       return std::pair{place(a), a} < std::pair{place(b), b};
                     });
    box.first_half = static_cast<Index>(boxes_.size());
    for (const auto& [begin, end] : {std::pair{box.begin, middle}, std::pair{middle, box.end}}) {
      boxes_.push_back({.begin = begin, .end = end, .first_half = -1});
    }
  }
  boxes_[static_cast<std::size_t>(number)] = box;
}

TriangleTree::Found TriangleTree::nearest(const Vector<3>& x) const noexcept {
  constexpr std::size_t deepest = 128;  // of the stack: two for each halving of at most 2^63 triangles
  std::array<Index, deepest> to_do{0};
  std::size_t count = 1;
  double least = std::numeric_limits<double>::infinity();
  Found found{least, x, Vector<3>::Unit(2)};
  while (count > 0) {
    const Box& box = boxes_[static_cast<std::size_t>(to_do[--count])];
    if (squared_distance(box.low, box.high, x) >= least) continue;
    if (box.first_half < 0) {
      for (Index i = box.begin; i < box.end; ++i) {
        const Index triangle = order_[static_cast<std::size_t>(i)];
        const NearestPlace near = nearest_on_triangle(corners(triangle), x);
        const double squared = (x - near.place).squaredNorm();
        if (squared >= least) continue;
        least = squared;
        found.place = near.place;
        found.pseudo_normal =
            normals_[static_cast<std::size_t>(triangle)][static_cast<std::size_t>(near.feature)];
      }
      continue;
    }
    const auto far_from = [&](Index half) {
      const Box& part = boxes_[static_cast<std::size_t>(half)];
      return squared_distance(part.low, part.high, x);
    };
    const bool second_is_nearer = far_from(box.first_half + 1) < far_from(box.first_half);
    to_do[count++] = box.first_half + (second_is_nearer ? 0 : 1);
    to_do[count++] = box.first_half + (second_is_nearer ? 1 : 0);
  }
  found.distance = std::sqrt(least);
  return found;
}

}  // namespace detail

TriangleSurface::TriangleSurface(TriangleMesh mesh)
    : tree_{std::make_shared<const detail::TriangleTree>(std::move(mesh))} {}

FromSurface<3> TriangleSurface::operator()(const Vector<3>& x) const noexcept {
  const auto found = tree_->nearest(x);
  const Vector<3> arm = x - found.place;
  const double sign = arm.dot(found.pseudo_normal) < 0 ? -1 : 1;
  // So near the surface the arm is rounding, and the pseudo-normal tells the way.
  const double rounding = 64 * round_off * x.cwiseAbs().maxCoeff();
  if (found.distance <= rounding) return {sign * found.distance, found.pseudo_normal.normalized()};
  return {sign * found.distance, sign / found.distance * arm};
}

}  // namespace scree::mpm
