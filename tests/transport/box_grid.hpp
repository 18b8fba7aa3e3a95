#pragma once

#include <scree/lattice.hpp>
#include <scree/transport/concepts.hpp>

#include <vector>

namespace scree::transport::test {

/// A lattice of cells as its faces: what a user's own grid could be, in any dimension. Ends that are not
/// periodic are the boundary "rim".
template <int D>
class BoxGrid {
 public:
  static constexpr int dimension = D;

  explicit BoxGrid(const Lattice<D>& lattice) : lattice_{lattice} {
    for (Index cell = 0; cell < lattice.num_sites(); ++cell) {
      for (int axis = 0; axis < D; ++axis) add_faces(cell, axis);
    }
  }

  [[nodiscard]] Index num_cells() const noexcept { return lattice_.num_sites(); }
  [[nodiscard]] Index num_faces() const noexcept { return static_cast<Index>(faces.size()); }
  [[nodiscard]] double volume(Index cell) const noexcept { return lattice_.volume(lattice_.site(cell)); }
  [[nodiscard]] Vector<D> centre(Index cell) const noexcept { return lattice_.position(lattice_.site(cell)); }
  [[nodiscard]] GridFace<D> face(Index i) const noexcept { return faces[static_cast<std::size_t>(i)]; }
  [[nodiscard]] int num_boundaries() const noexcept { return has_rim_ ? 1 : 0; }
  [[nodiscard]] std::string_view boundary_name(int /*boundary*/) const noexcept { return "rim"; }

  std::vector<GridFace<D>> faces;  // tests spoil them

 private:
  /// The face at the high end of a cell along an axis, and at its low end where there is no cell below.
  void add_faces(Index cell, int axis) {
    const auto a = static_cast<std::size_t>(axis);
    const Indices<D> site = lattice_.site(cell);
    const Vector<D> half = 0.5 * lattice_.spacing[axis] * Vector<D>::Unit(axis);
    const bool is_last = site[a] == lattice_.count[a] - 1;
    GridFace<D> face;
    face.owner = cell;
    face.normal = Vector<D>::Unit(axis);
    face.area = lattice_.face_area(site, axis);
    face.centre = lattice_.position(site) + half;
    face.from_owner = half;
    face.from_neighbour = -half;
    Indices<D> next = site;
    next[a] = is_last ? 0 : site[a] + 1;
    const bool is_rim = is_last && !lattice_.is_periodic[a];
    face.neighbour = is_rim ? no_site : lattice_.index(next);
    face.boundary = is_rim ? 0 : -1;
    faces.push_back(face);
    if (site[a] == 0 && !lattice_.is_periodic[a]) {
      face.neighbour = no_site;
      face.boundary = 0;
      face.normal = -face.normal;
      face.centre = lattice_.position(site) - half;
      face.from_owner = -half;
      faces.push_back(face);
      has_rim_ = true;
    }
  }

  Lattice<D> lattice_;
  bool has_rim_ = false;
};
static_assert(FaceGrid<BoxGrid<1>> && FaceGrid<BoxGrid<2>> && FaceGrid<BoxGrid<3>>);

}  // namespace scree::transport::test
