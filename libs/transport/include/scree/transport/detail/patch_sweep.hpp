#pragma once

#include <scree/transport/boundaries.hpp>
#include <scree/transport/cell_states.hpp>
#include <scree/transport/components.hpp>
#include <scree/transport/concepts.hpp>
#include <scree/transport/detail/cell_slopes.hpp>
#include <scree/transport/detail/face_fluxes.hpp>
#include <scree/transport/detail/non_orthogonal.hpp>
#include <scree/transport/detail/patch.hpp>
#include <scree/transport/reconstructions/piecewise_constant.hpp>

#include <algorithm>
#include <cmath>
#include <span>
#include <type_traits>
#include <variant>
#include <vector>

namespace scree::transport::detail {

/// What a sweep over patches found.
struct PatchReport {
  double limit = 0;        ///< CFL number of a step of one second, at the worst cell [1/s].  Eq. (T34)
  double speed = 0;        ///< largest [m/s]
  Index faulty = no_site;  ///< first cell whose rate or speeds are not finite

  void add(const PatchReport& other) noexcept {
    limit = std::max(limit, other.limit);
    speed = std::max(speed, other.speed);
    if (other.faulty != no_site) add_fault(other.faulty);
  }
  void add_fault(Index cell) noexcept { faulty = faulty == no_site ? cell : std::min(faulty, cell); }
};

/// The balance of the cells of one patch after the other: states of the cells around are copied in, then
/// states on all sides found, fluxes through all faces, and what they sum to in each cell.
///
/// Owns the work space, which stays in cache: one object for each thread.  Eqs. (T30) to (T36)
template <class Problem>
class PatchSweep {
 public:
  static constexpr int D = Problem::dimension;
  static constexpr int N = Problem::num_components;
  using Law = typename Problem::Law;
  using Reconstruct = std::remove_cvref_t<decltype(Problem::reconstruction)>;
  using Boundaries = std::vector<AnyBoundary<D, N>>;
  static constexpr bool has_slopes = !std::is_same_v<Reconstruct, PiecewiseConstant>;
  static constexpr bool has_diffusion = Diffusive<PointLawOf<Law>>;

  /// With room for the largest of `patches`.
  explicit PatchSweep(const std::vector<Patch<D>>& patches)
      : states_{largest(patches, [](const Patch<D>& patch) { return patch.cells.size(); })},
        side_states_{has_slopes ? largest(patches, [](const Patch<D>& patch) { return patch.offsets.size(); })
                                : 0} {
    const Index num_faces = largest(patches, [](const Patch<D>& patch) { return patch.faces.size(); });
    records_.resize(static_cast<std::size_t>(num_faces));
    if constexpr (has_diffusion) conductances_.resize(records_.size());
  }

  /// Hands du/dt of each own cell to write(cell, rate).
  template <class Write>
  PatchReport operator()(const Problem& problem, const Patch<D>& patch, const Boundaries& boundaries,
                         const CellStates<N>& fields, double time, const Write& write) noexcept {
    for (std::size_t i = 0; i < patch.cells.size(); ++i) {
      values_of<N>(states_, static_cast<Index>(i)) = values_of<N>(fields, patch.cells.data()[i]);
    }
    if constexpr (has_slopes) {
      find_side_states(patch, problem.law, problem.reconstruction, states_, bounds_, side_states_);
    }
    flux_inside(problem, patch);
    for (std::size_t number = 0; number < boundaries.size(); ++number) {
      flux_out(problem, patch, boundaries.data()[number], patch.first_boundary.data()[number],
               patch.first_boundary.data()[number + 1], time);
    }
    return balance(problem, patch, time, write);
  }

 private:
  using State = typename Problem::State;
  using PointLaw = PointLawOf<Law>;

  template <class Size>
  [[nodiscard]] static Index largest(const std::vector<Patch<D>>& patches, const Size& size) {
    std::size_t result = 0;
    for (const Patch<D>& patch : patches) result = std::max(result, size(patch));
    return static_cast<Index>(result);
  }

  /// States on the sides, or in the cells where there are no slopes: what FaceSides points into.
  [[nodiscard]] const CellStates<N>& sides() const noexcept {
    if constexpr (has_slopes) {
      return side_states_;
    } else {
      return states_;
    }
  }

  /// Fluxes through the faces between cells.
  void flux_inside(const Problem& problem, const Patch<D>& patch) noexcept {
    if constexpr (GridFaceDependent<Law, D>) {
      for (Index face = 0; face < patch.num_inner; ++face) flux_between(problem, patch, face);
    } else {
      for (Index first = 0; first < patch.num_inner; first += num_tile_faces) {
        const Index count = std::min(num_tile_faces, patch.num_inner - first);
        fill(tile_, patch, sides(), first, count);
        flux_through(problem.law, problem.flux, in_whole_packs(count), tile_);
        copy_fluxes(tile_, count, records_.data() + first);
      }
      if constexpr (has_diffusion) {
        for (Index face = 0; face < patch.num_inner; ++face) diffuse(problem.law, patch, face);
      }
    }
  }

  /// The same through one face, for laws that differ from face to face.
  void flux_between(const Problem& problem, const Patch<D>& patch, Index number) noexcept {
    const FaceSides& face = patch.faces.data()[number];
    const auto law = law_at<D>(problem.law, problem.grid.face(patch.original.data()[number]));
    const FaceFlux<State> flux =
        problem.flux(law, sides()[face.left], sides()[face.right], patch.normals.data()[number]);
    records_.data()[number] = {flux.value, flux.speed};
    if constexpr (has_diffusion) diffuse(law, patch, number);
  }

  /// Fluxes out through faces begin .. end - 1, of one boundary.  Eq. (T8)
  void flux_out(const Problem& problem, const Patch<D>& patch, const AnyBoundary<D, N>& any_boundary,
                Index begin, Index end, double time) noexcept {
    if (begin == end) return;
    const auto apply = [&](const auto& boundary) {
      for (Index i = begin; i < end; ++i) {
        FaceFlux<State> flux{};
        if constexpr (!std::remove_cvref_t<decltype(boundary)>::is_closed) {
          const GridFace<D> face = problem.grid.face(patch.original.data()[i]);
          const auto& law = law_at<D>(problem.law, face);
          flux = boundary.flux(problem.flux, law, sides()[patch.faces.data()[i].left],
                               BoundaryFace<D>{face.centre, face.normal, time});
        }
        records_.data()[i] = {flux.value, flux.speed};
      }
    };
    std::visit(apply, any_boundary);
  }

  void diffuse(const PointLaw& law, const Patch<D>& patch, Index face) noexcept {
    conductances_.data()[face] = add_diffusion(law, patch, states_, face, records_.data()[face].flux);
  }

  struct CellBalance {
    Vector<N> rate;
    double limit;   ///< [1/s]
    double speed;   ///< largest at a face [m/s]
    double speeds;  ///< sum over all faces: a NaN is not lost in it
  };

  /// du/dt of an own cell from the fluxes through its faces.  Eqs. (T30), (T34)
  [[nodiscard]] CellBalance balance_of(const Problem& problem, const Patch<D>& patch, Index i,
                                       double time) const noexcept {
    CellBalance result{Vector<N>::Zero(), 0, 0, 0};
    const FaceRecord<N>* records = records_.data();
    double diffusion = 0;
    for (const SideShare& side : patch.shares_of(i)) {
      const FaceRecord<N>& record = records[side.face];
      result.rate += side.rate * Eigen::Map<const Vector<N>>{record.flux.data()};
      result.speed = std::max(result.speed, record.speed);
      result.speeds += record.speed;
      if constexpr (has_slopes) {
        result.limit = std::max(result.limit, side.closeness * record.speed);
      } else {
        result.limit += 0.5 * std::abs(side.rate) * record.speed;
      }
      if constexpr (has_diffusion) diffusion += std::abs(side.rate) * conductances_.data()[side.face];
    }
    result.limit += diffusion;
    if constexpr (HasSource<Law, D>) {
      const State source = problem.law.source(states_[i], problem.grid.centre(patch.cells.data()[i]), time);
      for (int k = 0; k < N; ++k) result.rate[k] += source[static_cast<std::size_t>(k)];
    }
    return result;
  }

  /// Zero, or NaN where a number is not finite.
  [[nodiscard]] static Vector<N> fault_of(const CellBalance& cell) noexcept {
    return 0 * (cell.rate + Vector<N>::Constant(cell.speeds + cell.limit));
  }

  template <class Write>
  PatchReport balance(const Problem& problem, const Patch<D>& patch, double time,
                      const Write& write) const noexcept {
    PatchReport report;
    Vector<N> fault = Vector<N>::Zero();
    for (Index i = 0; i < patch.num_own; ++i) {
      const CellBalance cell = balance_of(problem, patch, i, time);
      write(patch.cells.data()[i], cell.rate);
      report.limit = std::max(report.limit, cell.limit);
      report.speed = std::max(report.speed, cell.speed);
      fault += fault_of(cell);
    }
    if (!(fault.sum() == 0)) find_fault(problem, patch, time, report);
    return report;
  }

  /// The first cell whose rate or speeds are not finite: maxima have passed over it.
  void find_fault(const Problem& problem, const Patch<D>& patch, double time,
                  PatchReport& report) const noexcept {
    for (Index i = 0; i < patch.num_own; ++i) {
      const bool is_fine = fault_of(balance_of(problem, patch, i, time)).sum() == 0;
      if (!is_fine) report.add_fault(patch.cells.data()[i]);
    }
  }

  CellStates<N> states_;       ///< of the patch's cells
  CellStates<N> side_states_;  ///< of their sides
  SlopeBounds<N> bounds_{};
  FaceTile<D, N> tile_{};
  std::vector<FaceRecord<N>> records_;
  std::vector<double> conductances_;  ///< of diffusion, of each face: diffusivity / distance [m/s]
};

}  // namespace scree::transport::detail
