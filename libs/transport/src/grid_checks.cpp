#include <scree/error.hpp>
#include <scree/transport/detail/grid_parts.hpp>
#include <scree/transport/detail/place.hpp>

#include <cmath>
#include <limits>
#include <sstream>

namespace scree::transport::detail {
namespace {

// How far a normal's length may be from 1, and the sum of a cell's area vectors from zero, as a part of the
// sum of its areas [-]: geometry that comes from files has some ten digits.
constexpr double rounded = 1e-8;

[[noreturn]] void fail(const std::ostringstream& text) {
  throw InputError{text.str()};
}

template <int D>
[[noreturn]] void fail_at_face(const GridFace<D>& face, std::size_t number, std::string_view what) {
  std::ostringstream text;
  text << "FaceGrid: face " << number << " at ";
  text << position_text<D>(face.centre);
  text << " m " << what;
  fail(text);
}

template <int D>
[[noreturn]] void fail_at_cell(const GridParts<D>& grid, std::size_t cell, const std::string& what) {
  std::ostringstream text;
  text << "FaceGrid: cell " << cell << " at ";
  text << position_text<D>(grid.centres[cell]);
  text << " m " << what;
  fail(text);
}

template <int D>
void check_face(const GridParts<D>& grid, std::size_t number) {
  const GridFace<D>& face = grid.faces[number];
  const auto num_cells = static_cast<Index>(grid.volumes.size());
  const auto is_cell = [&](Index i) { return 0 <= i && i < num_cells; };
  if (!is_cell(face.owner) || !(is_cell(face.neighbour) || face.neighbour == no_site)) {
    std::ostringstream text;
    text << "lies between cells " << face.owner << " and " << face.neighbour << ": must lie in [0, "
         << num_cells - 1 << "]";
    fail_at_face(face, number, text.str());
  }
  const bool has_boundary =
      0 <= face.boundary && static_cast<std::size_t>(face.boundary) < grid.boundary_names.size();
  if (face.neighbour == no_site && !has_boundary) {
    std::ostringstream text;
    text << "is on boundary " << face.boundary << " of " << grid.boundary_names.size();
    fail_at_face(face, number, text.str());
  }
  if (!(face.area > 0 && std::isfinite(face.area))) {
    fail_at_face(face, number, "has an area that is not positive and finite");
  }
  if (!(std::abs(face.normal.norm() - 1) <= rounded)) {
    fail_at_face(face, number, "has a normal that is not of length 1");
  }
  if (!(face.from_owner.dot(face.normal) > 0) ||
      (face.neighbour != no_site && !(face.from_neighbour.dot(face.normal) < 0))) {
    fail_at_face(face, number, "has a normal that does not point from its owner to its neighbour");
  }
}

/// @throws InputError unless the outward area vectors of every cell add to zero.
template <int D>
void check_closed(const GridParts<D>& grid) {
  std::vector<Vector<D>> sum(grid.volumes.size(), Vector<D>::Zero());
  std::vector<double> area(grid.volumes.size(), 0.0);
  for (const GridFace<D>& face : grid.faces) {
    const auto add = [&](Index i, double sign) {
      sum[static_cast<std::size_t>(i)] += sign * face.area * face.normal;
      area[static_cast<std::size_t>(i)] += face.area;
    };
    add(face.owner, 1);
    if (face.neighbour != no_site) add(face.neighbour, -1);
  }
  for (std::size_t cell = 0; cell < sum.size(); ++cell) {
    if (area[cell] > 0 && sum[cell].norm() <= rounded * area[cell]) continue;
    fail_at_cell(grid, cell, "is not closed: the outward areas of its faces do not add to zero");
  }
}

}  // namespace

template <int D>
void check_grid(const GridParts<D>& grid) {
  constexpr auto most = static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max());
  require(!grid.volumes.empty(), "FaceGrid: there must be at least one cell");
  require(grid.volumes.size() < most && grid.faces.size() < most, "FaceGrid: at most 2^31 cells and faces");
  for (std::size_t cell = 0; cell < grid.volumes.size(); ++cell) {
    if (grid.volumes[cell] > 0 && std::isfinite(grid.volumes[cell])) continue;
    fail_at_cell(grid, cell, "has a volume that is not positive and finite");
  }
  for (std::size_t number = 0; number < grid.faces.size(); ++number) check_face<D>(grid, number);
  check_closed<D>(grid);
}

template <int D>
void throw_not_finite_in_cell(Index cell, const Vector<D>& position) {
  std::ostringstream text;
  text << "transport: the rate of change is not finite in cell " << cell << ", position ";
  text << position_text<D>(position);
  text << " m";
  throw RunError{text.str()};
}

template void throw_not_finite_in_cell<1>(Index, const Vector<1>&);
template void throw_not_finite_in_cell<2>(Index, const Vector<2>&);
template void throw_not_finite_in_cell<3>(Index, const Vector<3>&);
template void check_grid<1>(const GridParts<1>&);
template void check_grid<2>(const GridParts<2>&);
template void check_grid<3>(const GridParts<3>&);

}  // namespace scree::transport::detail
