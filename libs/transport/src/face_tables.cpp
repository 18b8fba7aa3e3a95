#include "least_squares.hpp"

#include <scree/transport/detail/face_tables.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace scree::transport::detail {
namespace {

/// Inner faces in the order of their cells, then the boundaries one by one.
template <int D>
std::vector<Index> face_order(const std::vector<GridFace<D>>& faces) {
  std::vector<Index> order(faces.size());
  std::iota(order.begin(), order.end(), Index{0});
  const auto key = [&](Index i) {
    const GridFace<D>& face = faces[static_cast<std::size_t>(i)];
    const bool is_inner = face.neighbour != no_site;
    const Index low = is_inner ? std::min(face.owner, face.neighbour) : face.owner;
    const Index high = is_inner ? std::max(face.owner, face.neighbour) : face.owner;
    return std::tuple{is_inner ? -1 : face.boundary, low, high, i};
  };
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return key(a) < key(b); });
  return order;
}

template <int D>
void add_face(FaceTables<D>& tables, const GridFace<D>& face, Index number) {
  const bool is_inner = face.neighbour != no_site;
  if (is_inner) ++tables.num_inner;
  for (int d = 0; d < D; ++d) {
    tables.normals[static_cast<std::size_t>(d * tables.num_faces + static_cast<Index>(tables.faces.size()))] =
        face.normal[d];
  }
  tables.faces.push_back({static_cast<std::int32_t>(face.owner),
                          static_cast<std::int32_t>(is_inner ? face.neighbour : face.owner), face.from_owner,
                          is_inner ? face.from_neighbour : face.from_owner});
  tables.original.push_back(number);
}

/// Fills in the faces of each cell, in the order of the faces.
template <int D>
void add_cell_faces(FaceTables<D>& tables, const GridParts<D>& grid) {
  std::vector<Index>& first = tables.first_cell_face;
  first.assign(grid.volumes.size() + 1, 0);
  const auto cell = [](Index i) { return static_cast<std::size_t>(i); };
  for (const GridFace<D>& face : grid.faces) {
    ++first[cell(face.owner) + 1];
    if (face.neighbour != no_site) ++first[cell(face.neighbour) + 1];
  }
  for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  tables.cell_faces.resize(static_cast<std::size_t>(first.back()));
  std::vector<Index> next = first;
  for (std::size_t f = 0; f < tables.original.size(); ++f) {
    const GridFace<D>& face = grid.faces[static_cast<std::size_t>(tables.original[f])];
    const auto add = [&](Index i, double sign, const Vector<D>& offset) {
      const double distance = std::abs(offset.dot(face.normal));
      tables.cell_faces[static_cast<std::size_t>(next[cell(i)]++)] = {
          static_cast<std::int32_t>(f), sign * face.area / grid.volumes[cell(i)], D / (2 * distance), offset};
    };
    add(face.owner, -1, face.from_owner);
    if (face.neighbour != no_site) add(face.neighbour, 1, face.from_neighbour);
  }
}

}  // namespace

template <int D>
FaceTables<D> make_face_tables(const GridParts<D>& grid, int rings) {
  FaceTables<D> tables;
  tables.num_cells = static_cast<Index>(grid.volumes.size());
  tables.num_faces = static_cast<Index>(grid.faces.size());
  tables.normals.resize(grid.faces.size() * D);
  std::vector<Index> num_faces(grid.boundary_names.size());
  for (const Index number : face_order<D>(grid.faces)) {
    const GridFace<D>& face = grid.faces[static_cast<std::size_t>(number)];
    add_face<D>(tables, face, number);
    if (face.neighbour == no_site) ++num_faces[static_cast<std::size_t>(face.boundary)];
  }
  tables.first_boundary.push_back(tables.num_inner);
  for (const Index count : num_faces) tables.first_boundary.push_back(tables.first_boundary.back() + count);
  add_cell_faces<D>(tables, grid);
  for (const double volume : grid.volumes) tables.widths.push_back(std::pow(volume, 1.0 / D));
  if (rings > 0) {
    Stencils<D> stencils = make_stencils<D>(grid, rings);
    tables.stencil = std::move(stencils.cells);
    tables.first_stencil_cell = std::move(stencils.first);
  }
  return tables;
}

template FaceTables<1> make_face_tables<1>(const GridParts<1>&, int);
template FaceTables<2> make_face_tables<2>(const GridParts<2>&, int);
template FaceTables<3> make_face_tables<3>(const GridParts<3>&, int);

}  // namespace scree::transport::detail
