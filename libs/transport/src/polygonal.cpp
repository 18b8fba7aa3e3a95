#include "polygon_checks.hpp"

#include <scree/error.hpp>
#include <scree/transport/detail/place.hpp>
#include <scree/transport/grids/polygonal.hpp>

#include <algorithm>
#include <sstream>
#include <tuple>
#include <utility>

namespace scree::transport {
namespace {

// Distance within which two edges of a periodic pair are one, in lengths of the edge [-]: files hold
// coordinates with some ten digits.
constexpr double same_place = 1e-6;

/// A side of a cell, from its owner's corner to the next one.
struct Side {
  Index low;   ///< the smaller of both vertices
  Index high;  ///< the larger
  Index cell;
  bool is_forward;  ///< the cell goes from low to high
};

using Sides = std::vector<Side>;

[[nodiscard]] const Vector<2>& vertex(const PolygonalMesh& mesh, Index i) {
  return mesh.vertices[static_cast<std::size_t>(i)];
}

[[noreturn]] void fail_at_edge(const PolygonalMesh& mesh, const Side& side, std::string_view what) {
  std::ostringstream text;
  text << "Polygonal: the edge of cell " << side.cell << " between vertices " << side.low << " and "
       << side.high << ", at ";
  text << detail::position_text<2>((vertex(mesh, side.low) + vertex(mesh, side.high)) / 2);
  text << " m, " << what;
  throw InputError{text.str()};
}

/// All sides, those of one edge together.
[[nodiscard]] Sides sides_of(const PolygonalMesh& mesh) {
  Sides sides;
  sides.reserve(mesh.corners.size());
  for (Index cell = 0; cell < mesh.num_cells(); ++cell) {
    const auto corners = mesh.cell(cell);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Index from = corners[i];
      const Index to = corners[(i + 1) % corners.size()];
      sides.push_back({std::min(from, to), std::max(from, to), cell, from < to});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.cell) < std::tie(b.low, b.high, b.cell);
  });
  return sides;
}

[[nodiscard]] GridFace<2> face_of(const PolygonalMesh& mesh, const Side& side, const Vector<2>& cell_centre) {
  const Vector<2>& from = vertex(mesh, side.is_forward ? side.low : side.high);
  const Vector<2>& to = vertex(mesh, side.is_forward ? side.high : side.low);
  const Vector<2> along = to - from;
  GridFace<2> face;
  face.owner = side.cell;
  face.neighbour = no_site;
  face.boundary = -1;
  face.area = along.norm();
  face.normal = Vector<2>{along[1], -along[0]} / face.area;
  face.centre = (from + to) / 2;
  face.from_owner = face.centre - cell_centre;
  face.from_neighbour = Vector<2>::Zero();
  return face;
}

/// The boundary of each edge of the rim, found by its vertices.
class BoundaryOfEdge {
 public:
  explicit BoundaryOfEdge(const PolygonalMesh& mesh) {
    for (const BoundaryEdge& edge : mesh.boundary_edges) {
      edges_.push_back({std::min(edge.from, edge.to), std::max(edge.from, edge.to), edge.boundary});
    }
    std::sort(edges_.begin(), edges_.end(), [](const BoundaryEdge& a, const BoundaryEdge& b) {
      return std::tie(a.from, a.to, a.boundary) < std::tie(b.from, b.to, b.boundary);
    });
    is_used_.resize(edges_.size());
  }

  /// The boundary of an edge; -1 if it is on none.  @throws InputError if it is there twice.
  [[nodiscard]] int find(const PolygonalMesh& mesh, const Side& side) {
    const auto is_before = [](const BoundaryEdge& edge, const Side& s) {
      return std::tie(edge.from, edge.to) < std::tie(s.low, s.high);
    };
    const auto found = std::lower_bound(edges_.begin(), edges_.end(), side, is_before);
    const auto is_edge = [&](auto it) {
      return it != edges_.end() && it->from == side.low && it->to == side.high;
    };
    if (!is_edge(found)) return -1;
    if (is_edge(found + 1)) fail_at_edge(mesh, side, "has more than one boundary tag");
    is_used_[static_cast<std::size_t>(found - edges_.begin())] = true;
    return found->boundary;
  }

  /// @throws InputError if a boundary edge was no edge of the mesh.
  void require_all_used(const PolygonalMesh& mesh) const {
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      if (is_used_[i]) continue;
      std::ostringstream text;
      text << "Polygonal: the boundary edge of \""
           << mesh.boundary_names[static_cast<std::size_t>(edges_[i].boundary)] << "\" between vertices "
           << edges_[i].from << " and " << edges_[i].to << " is no edge of a cell";
      throw InputError{text.str()};
    }
  }

 private:
  std::vector<BoundaryEdge> edges_;
  std::vector<bool> is_used_;
};

/// Faces from sides: inner ones from two, those of the rim from one, with the tag of their boundary.
[[nodiscard]] std::vector<GridFace<2>> make_faces(const PolygonalMesh& mesh,
                                                  const std::vector<Vector<2>>& centres) {
  const Sides sides = sides_of(mesh);
  BoundaryOfEdge boundary_of{mesh};
  std::vector<GridFace<2>> faces;
  faces.reserve(sides.size());
  for (std::size_t i = 0; i < sides.size();) {
    const Side& side = sides[i];
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].low == side.low && sides[end].high == side.high) ++end;
    if (end - i > 2) fail_at_edge(mesh, side, "has more than two cells");
    GridFace<2> face = face_of(mesh, side, centres[static_cast<std::size_t>(side.cell)]);
    face.boundary = boundary_of.find(mesh, side);
    if (end - i == 2) {
      const Side& other = sides[i + 1];
      if (other.is_forward == side.is_forward) {
        fail_at_edge(mesh, side,
                     "has both cells on one side: they overlap, cell " + std::to_string(other.cell));
      }
      if (face.boundary >= 0) fail_at_edge(mesh, side, "has a boundary tag, but cells on both sides");
      face.neighbour = other.cell;
      face.from_neighbour = face.centre - centres[static_cast<std::size_t>(other.cell)];
    } else if (face.boundary < 0) {
      fail_at_edge(mesh, side, "is on the rim of the mesh, but has no boundary tag");
    }
    faces.push_back(face);
    i = end;
  }
  boundary_of.require_all_used(mesh);
  return faces;
}

[[nodiscard]] int boundary_number(const PolygonalMesh& mesh, const std::string& name) {
  const auto found = std::find(mesh.boundary_names.begin(), mesh.boundary_names.end(), name);
  if (found != mesh.boundary_names.end()) return static_cast<int>(found - mesh.boundary_names.begin());
  throw InputError{"Polygonal: there is no boundary \"" + name + "\" to be periodic"};
}

[[noreturn]] void fail_without_partner(const PeriodicPair& pair, const GridFace<2>& face) {
  std::ostringstream text;
  text << "Polygonal: the face at ";
  text << detail::position_text<2>(face.centre);
  text << " m of the periodic boundary \"" << pair.first << "\" has no partner on \"" << pair.second
       << "\" at ";
  text << detail::position_text<2>(Vector<2>{face.centre + pair.translation});
  text << " m";
  throw InputError{text.str()};
}

/// Makes each face of `pair.first` an inner face, with the cell behind its partner as neighbour, and takes
/// the partner away.
void join(const PolygonalMesh& mesh, const PeriodicPair& pair, std::vector<GridFace<2>>& faces) {
  const int first = boundary_number(mesh, pair.first);
  const int second = boundary_number(mesh, pair.second);
  // Along the boundary, so that partners are near each other in both lists.
  const Vector<2> across{-pair.translation[1], pair.translation[0]};
  std::vector<std::pair<double, std::size_t>> partners;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (faces[i].boundary == second) partners.emplace_back(faces[i].centre.dot(across), i);
  }
  std::sort(partners.begin(), partners.end());
  std::vector<bool> is_taken(faces.size());
  for (GridFace<2>& face : faces) {
    if (face.boundary != first) continue;
    const Vector<2> image = face.centre + pair.translation;
    const double tolerance = same_place * face.area;
    const double place = image.dot(across);
    auto candidate = std::lower_bound(partners.begin(), partners.end(),
                                      std::pair{place - tolerance * across.norm(), std::size_t{0}});
    const auto is_partner = [&](const GridFace<2>& other) {
      return (other.centre - image).norm() <= tolerance &&
             (other.normal + face.normal).norm() <= same_place &&
             std::abs(other.area - face.area) <= tolerance;
    };
    while (candidate != partners.end() && !is_partner(faces[candidate->second]) &&
           candidate->first <= place + tolerance * across.norm()) {
      ++candidate;
    }
    if (candidate == partners.end() || !is_partner(faces[candidate->second]))
      fail_without_partner(pair, face);
    const GridFace<2>& partner = faces[candidate->second];
    face.neighbour = partner.owner;
    face.from_neighbour = partner.from_owner;
    face.boundary = -1;
    is_taken[candidate->second] = true;
  }
  const PeriodicPair back{pair.second, pair.first, -pair.translation};
  std::vector<GridFace<2>> kept;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (is_taken[i]) continue;
    if (faces[i].boundary == second) fail_without_partner(back, faces[i]);
    kept.push_back(faces[i]);
  }
  faces = std::move(kept);
}

/// @throws InputError naming a cell that faces do not join to cell 0.
void check_connected(const PolygonalMesh& mesh, const std::vector<GridFace<2>>& faces) {
  std::vector<Index> root(static_cast<std::size_t>(mesh.num_cells()));
  for (std::size_t i = 0; i < root.size(); ++i) root[i] = static_cast<Index>(i);
  std::vector<bool> has_neighbour(root.size());
  const auto find_root = [&](Index i) {
    while (root[static_cast<std::size_t>(i)] != i) {
      const Index above = root[static_cast<std::size_t>(i)];
      root[static_cast<std::size_t>(i)] = root[static_cast<std::size_t>(above)];
      i = above;
    }
    return i;
  };
  for (const GridFace<2>& face : faces) {
    if (face.neighbour == no_site) continue;
    const Index a = find_root(face.owner);
    const Index b = find_root(face.neighbour);
    root[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    has_neighbour[static_cast<std::size_t>(face.owner)] = true;
    has_neighbour[static_cast<std::size_t>(face.neighbour)] = true;
  }
  for (Index cell = 0; cell < mesh.num_cells() && mesh.num_cells() > 1; ++cell) {
    if (has_neighbour[static_cast<std::size_t>(cell)] && find_root(cell) == 0) continue;
    std::ostringstream text;
    text << "Polygonal: cell " << cell << " at ";
    text << detail::position_text<2>(detail::middle_of(mesh, cell));
    text << " m "
         << (has_neighbour[static_cast<std::size_t>(cell)] ? "is not connected to cell 0"
                                                           : "has no neighbour");
    throw InputError{text.str()};
  }
}

/// Drops boundaries without a face and numbers the others from 0 on. @return the names that are left
[[nodiscard]] std::vector<std::string> number_boundaries(const PolygonalMesh& mesh,
                                                         std::vector<GridFace<2>>& faces) {
  std::vector<int> number(mesh.boundary_names.size(), -1);
  for (const GridFace<2>& face : faces) {
    if (face.boundary >= 0) number[static_cast<std::size_t>(face.boundary)] = 0;
  }
  std::vector<std::string> names;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] < 0) continue;
    number[i] = static_cast<int>(names.size());
    names.push_back(mesh.boundary_names[i]);
  }
  for (GridFace<2>& face : faces) {
    if (face.boundary >= 0) face.boundary = number[static_cast<std::size_t>(face.boundary)];
  }
  return names;
}

}  // namespace

Polygonal::Polygonal(PolygonalMesh mesh) : mesh_{std::move(mesh)} {
  detail::check_polygons(mesh_);
  for (Index cell = 0; cell < mesh_.num_cells(); ++cell) {
    const auto corners = mesh_.cell(cell);
    const Vector<2>& origin = vertex(mesh_, corners[0]);  // differences lose no digits far from (0, 0)
    double area = 0;
    Vector<2> moment = Vector<2>::Zero();
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      const Vector<2> a = vertex(mesh_, corners[i]) - origin;
      const Vector<2> b = vertex(mesh_, corners[i + 1]) - origin;
      const double part = (a[0] * b[1] - a[1] * b[0]) / 2;
      area += part;
      moment += part * (a + b) / 3;
    }
    volumes_.push_back(area);
    centres_.emplace_back(origin + moment / area);
  }
  faces_ = make_faces(mesh_, centres_);
  for (const PeriodicPair& pair : mesh_.periodic_pairs) join(mesh_, pair, faces_);
  check_connected(mesh_, faces_);
  boundary_names_ = number_boundaries(mesh_, faces_);
}

}  // namespace scree::transport
