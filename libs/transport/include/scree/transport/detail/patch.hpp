#pragma once

#include <scree/transport/detail/grid_parts.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace scree::transport::detail {

/// Loops over faces and over components run on whole packs of so many: each face of two patches is worked on
/// by the same instructions in both, and has the same flux.
constexpr Index pack = 8;

[[nodiscard]] constexpr Index in_whole_packs(Index count) noexcept {
  return (count + pack - 1) / pack * pack;
}

/// A cell that a gradient is made from: it adds weight x (its value - the cell's own).  Eq. (T32a)
template <int D>
struct StencilCell {
  std::int32_t cell;
  /// In widths of the cell [-]. Single precision will do: Patch::corrections makes good what it rounds.
  std::array<float, static_cast<std::size_t>(D)> weight;
};

/// What passes through a face counts for in one of its cells.
struct SideShare {
  std::int32_t face;
  double rate;       ///< area/volume, negative where the normal points outward [1/m]
  double closeness;  ///< D/(2 x distance of the face from the centre) [1/m].  Eq. (T34)
};

/// The sides of a face, or its cells where there are no slopes: what is on the owner's side and the other.
struct FaceSides {
  std::int32_t left;
  std::int32_t right;  ///< on a boundary as the left one
};

/// What diffusion asks of a face.
template <int D>
struct FaceCells {
  std::int32_t owner;
  std::int32_t neighbour;
  Vector<D> between;  ///< from the owner's centre to the neighbour's [m]
};

/// Some cells of a grid, to be worked on while they are in cache, and all that their balance needs, in
/// numbers of the patch: first its own cells; then those behind their faces, whose gradients are made here
/// once more; then those that gradients are made from besides. Nothing of other patches is waited for.
///
/// A *side* is a face as one of its cells sees it. The sides of a cell follow each other.
template <int D>
struct Patch {
  std::vector<std::int32_t> cells;  ///< the grid's number of each
  Index num_own = 0;
  Index num_near = 0;  ///< own cells and those behind their faces: the ones that have sides

  std::vector<std::int32_t> first_stencil_cell;  ///< of each near cell, and one past the last
  std::vector<StencilCell<D>> stencil;
  std::vector<Matrix<D>> corrections;    ///< of a near cell, what its weighted sum is multiplied by [1/m]
  std::vector<double> widths;            ///< of a near cell: volume^(1/D) [m]
  std::vector<std::int32_t> first_side;  ///< of each near cell, and one past the last
  std::vector<Vector<D>> offsets;        ///< of each side: from the cell's centre to the face's [m]
  std::vector<SideShare> shares;         ///< of each side of an own cell

  Index num_inner = 0;                       ///< faces between two cells; they come first
  std::vector<FaceSides> faces;              ///< of own cells
  std::vector<Vector<D>> normals;            ///< of each face, unit, out of the owner [-]
  std::vector<FaceCells<D>> ends;            ///< of each face between two cells, if there is diffusion
  std::vector<std::int32_t> original;        ///< the grid's number of each face
  std::vector<std::int32_t> first_boundary;  ///< first face of each boundary, and one past the last

  [[nodiscard]] std::span<const StencilCell<D>> stencil_of(Index cell) const noexcept {
    const std::int32_t* first = first_stencil_cell.data() + cell;
    return {stencil.data() + first[0], stencil.data() + first[1]};
  }
  [[nodiscard]] std::span<const SideShare> shares_of(Index own_cell) const noexcept {
    const std::int32_t* first = first_side.data() + own_cell;
    return {shares.data() + first[0], shares.data() + first[1]};
  }
};

/// What patches are made for.
struct PatchNeeds {
  int rings;  ///< of neighbours that gradients are made from; 0: there are none
  bool has_slopes;
  bool has_diffusion;
};

/// Cuts a grid into patches of cells that lie together, whatever their numbers.
template <int D>
[[nodiscard]] std::vector<Patch<D>> make_patches(const GridParts<D>& grid, PatchNeeds needs);

extern template std::vector<Patch<1>> make_patches<1>(const GridParts<1>&, PatchNeeds);
extern template std::vector<Patch<2>> make_patches<2>(const GridParts<2>&, PatchNeeds);
extern template std::vector<Patch<3>> make_patches<3>(const GridParts<3>&, PatchNeeds);

}  // namespace scree::transport::detail
