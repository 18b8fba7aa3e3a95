#pragma once

#include <scree/transport/detail/row_balance.hpp>
#include <scree/transport/detail/row_kernels.hpp>
#include <scree/transport/detail/tiles.hpp>
#include <scree/transport/discretisation.hpp>
#include <scree/transport/reconstructions/any_reconstruction.hpp>

#include <type_traits>
#include <variant>

// Reconstruction and fluxes of rows of any length, cut into packs; fluxes through boundaries.

namespace scree::transport::detail {

/// What flows, and how it is now.
template <class Problem>
struct Flow {
  const Problem& problem;
  const Fields<Problem::num_components>& fields;
  double time;  ///< of boundaries and sources [s]

  [[nodiscard]] auto sites() const noexcept {
    return StoredSites<typename Problem::Grid, Problem::num_components>{problem.grid, fields};
  }
};

template <class Problem>
using FluxTileOf = FluxTile<Problem::num_components, Diffusive<PointLawOf<typename Problem::Law>>>;

template <class Sites, class R, class Ratios>
void reconstruct_row(const Sites& sites, const R& reconstruction, const StencilRow<Ratios>& row, double* low,
                     double* high) noexcept {
  in_packs(row.count, [&](Index begin, Index count) {
    reconstruct(sites, reconstruction, row.part(begin, count), low + begin, high + begin);
  });
}

template <class Sites, class... Rs, class Ratios>
void reconstruct_row(const Sites& sites, const AnyReconstruction<Rs...>& reconstruction,
                     const StencilRow<Ratios>& row, double* low, double* high) noexcept {
  std::visit([&](const auto& chosen) { reconstruct_row(sites, chosen, row, low, high); },
             reconstruction.choice);
}

template <class Problem, class Distance>
void flux_through_row(const Flow<Problem>& flow, const FaceRow<Distance>& row, const double* left,
                      const double* right, double* flux, Largest& speed) noexcept {
  in_packs(row.count, [&](Index begin, Index count) {
    flux_between(flow.problem.grid, flow.problem.law, flow.problem.flux, flow.fields, row.part(begin, count),
                 left + begin, right + begin, flux + begin, speed.lanes() + begin);
  });
}

/// Boundary faces of `count` sites in a row, at one end of an axis.
template <int D>
struct BoundaryRow {
  Indices<D> site;  ///< coordinates of the first
  Index first;      ///< its number
  Index count;
  int axis;
  End end;
  double distance;  ///< from a site to its mirror image [m]
};

/// Writes a flux out through a boundary face as one along the axis.
/// @param density of the site inside: nothing passes out of an empty one
template <class Problem>
void write_flux(const FaceFlux<typename Problem::State>& face, double density, double sign, double* flux,
                Largest& speed) noexcept {
  using Out = FluxTileOf<Problem>;
  const bool is_open = density > 0;
  for (int k = 0; k < Problem::num_components; ++k) {
    flux[k * Out::stride] = is_open ? sign * density * face.value[static_cast<std::size_t>(k)] : 0.0;
  }
  flux[Out::drain * Out::stride] = is_open ? density * face.speed : 0.0;
  if constexpr (Out::has_diffusion) flux[Out::diffusion * Out::stride] = 0;
  double& fastest = *speed.lanes();
  if (is_open && face.speed > fastest) fastest = face.speed;
}

/// Fluxes through boundary faces, along the axis.  Eq. (T8)
template <class Problem>
void flux_out(const Flow<Problem>& flow, BoundaryRow<Problem::dimension> row, double* flux,
              Largest& speed) noexcept {
  constexpr int D = Problem::dimension;
  const Problem& problem = flow.problem;
  const double sign = row.end == End::low ? -1 : 1;
  BoundaryFace<D> at{{}, sign * Vector<D>::Unit(row.axis), flow.time};
  const auto apply = [&](const auto& boundary) {
    for (Index i = 0; i < row.count; ++i) {
      FaceFlux<typename Problem::State> face{};
      if constexpr (!std::remove_cvref_t<decltype(boundary)>::is_closed) {
        at.centre = problem.grid.position(row.site);
        at.centre[row.axis] = problem.grid.end(row.axis, row.end);
        const auto law = law_at(problem.law, Face{row.first + i, no_site, row.axis, row.distance});
        face = boundary.flux(problem.flux, law, flow.fields[row.first + i], at);
      }
      write_flux<Problem>(face, problem.grid.density(row.first + i), sign, flux + i, speed);
      ++row.site[0];
    }
  };
  std::visit(apply,
             problem.boundaries[static_cast<std::size_t>(row.axis)][static_cast<std::size_t>(row.end)]);
}

}  // namespace scree::transport::detail
