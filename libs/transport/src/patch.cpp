#include "least_squares.hpp"

#include <scree/transport/detail/patch.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace scree::transport::detail {
namespace {

// Few enough that states and fluxes of a patch (0.3 MB for a gas on triangles) stay in a core's own cache,
// many enough that the cells on its rim, worked on twice, are few (8 %).
constexpr Index most_cells = 2048;

[[nodiscard]] std::size_t at(Index i) {
  return static_cast<std::size_t>(i);
}

/// Halves cells across their longest extent until no more than most_cells are left together.
template <int D, class Visit>
void bisect(const std::vector<Vector<D>>& centres, std::span<Index> cells, const Visit& visit) {
  if (cells.size() <= most_cells) {
    std::sort(cells.begin(), cells.end());
    visit(cells);
    return;
  }
  Vector<D> low = centres[at(cells[0])];
  Vector<D> high = low;
  for (const Index cell : cells) {
    low = low.cwiseMin(centres[at(cell)]);
    high = high.cwiseMax(centres[at(cell)]);
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  const std::size_t half = cells.size() / 2;
  const auto is_before = [&](Index a, Index b) {
    return std::tuple{centres[at(a)][axis], a} < std::tuple{centres[at(b)][axis], b};
  };
  std::nth_element(cells.begin(), cells.begin() + static_cast<Index>(half), cells.end(), is_before);
  bisect<D>(centres, cells.first(half), visit);
  bisect<D>(centres, cells.subspan(half), visit);
}

/// A face as one of its cells sees it.
struct Side {
  Index face;
  bool is_owner;
};

/// The sides of all cells, in the order of the faces.
template <int D>
class Sides {
 public:
  explicit Sides(const GridParts<D>& grid) : first_(grid.volumes.size() + 1) {
    for (const GridFace<D>& face : grid.faces) {
      ++first_[at(face.owner) + 1];
      if (face.neighbour != no_site) ++first_[at(face.neighbour) + 1];
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    sides_.resize(at(first_.back()));
    std::vector<Index> next = first_;
    for (std::size_t i = 0; i < grid.faces.size(); ++i) {
      const GridFace<D>& face = grid.faces[i];
      const auto number = static_cast<Index>(i);
      sides_[at(next[at(face.owner)]++)] = {number, true};
      if (face.neighbour != no_site) sides_[at(next[at(face.neighbour)]++)] = {number, false};
    }
  }

  [[nodiscard]] std::span<const Side> of(Index cell) const {
    return std::span{sides_}.subspan(at(first_[at(cell)]), at(first_[at(cell) + 1] - first_[at(cell)]));
  }

 private:
  std::vector<Index> first_;
  std::vector<Side> sides_;
};

/// Numbers things of a grid anew, in the order in which they are added.
class Numbers {
 public:
  explicit Numbers(std::size_t count) : number_(count, -1) {}

  /// @return the number of a thing, a new one if it has none
  std::int32_t add(Index old) {
    std::int32_t& number = number_[at(old)];
    if (number < 0) {
      number = static_cast<std::int32_t>(old_.size());
      old_.push_back(static_cast<std::int32_t>(old));
    }
    return number;
  }

  /// Whether a thing has a number.
  [[nodiscard]] bool has(Index old) const { return number_[at(old)] >= 0; }
  /// The old number of each.
  [[nodiscard]] const std::vector<std::int32_t>& old() const { return old_; }
  [[nodiscard]] Index count() const { return static_cast<Index>(old_.size()); }

  void clear() {
    for (const std::int32_t old : old_) number_[at(old)] = -1;
    old_.clear();
  }

 private:
  std::vector<std::int32_t> number_;
  std::vector<std::int32_t> old_;
};

template <int D>
class PatchMaker {
 public:
  PatchMaker(const GridParts<D>& grid, PatchNeeds needs)
      : grid_{grid}, needs_{needs}, sides_{grid}, cells_(grid.volumes.size()), faces_(grid.faces.size()) {
    if (needs.rings > 0) stencils_ = make_stencils<D>(grid, needs.rings);
  }

  [[nodiscard]] Patch<D> make(std::span<const Index> own) {
    cells_.clear();
    faces_.clear();
    Patch<D> patch;
    number_cells_and_faces(own, patch);
    add_sides(patch);
    if (needs_.rings > 0) add_gradients(patch);
    add_faces(patch);
    patch.cells = cells_.old();
    return patch;
  }

 private:
  [[nodiscard]] const GridFace<D>& face(Index number) const { return grid_.faces[at(number)]; }

  /// Cells: own ones, then those behind their faces. Faces: between cells, then boundary by boundary.
  void number_cells_and_faces(std::span<const Index> own, Patch<D>& patch) {
    for (const Index cell : own) cells_.add(cell);
    patch.num_own = cells_.count();
    std::vector<Index> on_boundaries;
    for (const Index cell : own) {
      for (const Side& side : sides_.of(cell)) {
        const GridFace<D>& seen = face(side.face);
        if (seen.neighbour == no_site) {
          on_boundaries.push_back(side.face);
        } else {
          cells_.add(side.is_owner ? seen.neighbour : seen.owner);
          faces_.add(side.face);
        }
      }
    }
    patch.num_near = cells_.count();
    patch.num_inner = faces_.count();
    std::stable_sort(on_boundaries.begin(), on_boundaries.end(),
                     [&](Index a, Index b) { return face(a).boundary < face(b).boundary; });
    for (const Index number : on_boundaries) faces_.add(number);
  }

  void add_sides(Patch<D>& patch) {
    patch.faces.resize(at(faces_.count()));
    patch.first_side.push_back(0);
    std::int32_t side_number = 0;
    for (Index i = 0; i < patch.num_near; ++i) {
      const Index cell = cells_.old()[at(i)];
      for (const Side& side : sides_.of(cell)) {
        const GridFace<D>& seen = face(side.face);
        const Vector<D>& offset = side.is_owner ? seen.from_owner : seen.from_neighbour;
        if (needs_.has_slopes) patch.offsets.push_back(offset);
        if (faces_.has(side.face)) {
          FaceSides& sides = patch.faces[at(faces_.add(side.face))];
          (side.is_owner ? sides.left : sides.right) =
              needs_.has_slopes ? side_number : static_cast<std::int32_t>(i);
          if (seen.neighbour == no_site) sides.right = sides.left;
        }
        if (i < patch.num_own) {
          const double rate = (side.is_owner ? -1 : 1) * seen.area / grid_.volumes[at(cell)];
          const double distance = std::abs(offset.dot(seen.normal));
          patch.shares.push_back({faces_.add(side.face), rate, D / (2 * distance)});
        }
        ++side_number;
      }
      patch.first_side.push_back(side_number);
    }
  }

  void add_gradients(Patch<D>& patch) {
    patch.first_stencil_cell.push_back(0);
    for (Index i = 0; i < patch.num_near; ++i) {
      const std::size_t cell = at(cells_.old()[at(i)]);
      for (Index j = stencils_.first[cell]; j < stencils_.first[cell + 1]; ++j) {
        StencilCell<D> near = stencils_.cells[at(j)];
        near.cell = cells_.add(near.cell);
        patch.stencil.push_back(near);
      }
      patch.first_stencil_cell.push_back(static_cast<std::int32_t>(patch.stencil.size()));
      patch.corrections.push_back(stencils_.corrections[cell]);
      patch.widths.push_back(std::pow(grid_.volumes[cell], 1.0 / D));
    }
  }

  void add_faces(Patch<D>& patch) {
    patch.original = faces_.old();
    patch.first_boundary.assign(grid_.boundary_names.size() + 1, 0);
    patch.first_boundary[0] = static_cast<std::int32_t>(patch.num_inner);
    for (const Index number : patch.original) {
      const GridFace<D>& seen = face(number);
      const bool is_inner = seen.neighbour != no_site;
      patch.normals.push_back(seen.normal);
      if (!is_inner) ++patch.first_boundary[at(seen.boundary) + 1];
      if (needs_.has_diffusion && is_inner) {
        patch.ends.push_back(
            {cells_.add(seen.owner), cells_.add(seen.neighbour), seen.from_owner - seen.from_neighbour});
      }
    }
    std::partial_sum(patch.first_boundary.begin(), patch.first_boundary.end(), patch.first_boundary.begin());
  }

  const GridParts<D>& grid_;
  PatchNeeds needs_;
  Sides<D> sides_;
  Stencils<D> stencils_;
  Numbers cells_;
  Numbers faces_;
};

}  // namespace

template <int D>
std::vector<Patch<D>> make_patches(const GridParts<D>& grid, PatchNeeds needs) {
  std::vector<Index> cells(grid.volumes.size());
  std::iota(cells.begin(), cells.end(), Index{0});
  PatchMaker<D> maker{grid, needs};
  std::vector<Patch<D>> patches;
  bisect<D>(grid.centres, cells, [&](std::span<const Index> own) {
    const Patch<D> patch = maker.make(own);
    patches.push_back(patch);  // a copy has no room to grow
  });
  return patches;
}

template std::vector<Patch<1>> make_patches<1>(const GridParts<1>&, PatchNeeds);
template std::vector<Patch<2>> make_patches<2>(const GridParts<2>&, PatchNeeds);
template std::vector<Patch<3>> make_patches<3>(const GridParts<3>&, PatchNeeds);

}  // namespace scree::transport::detail
