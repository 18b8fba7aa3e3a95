#pragma once

#include "../cpu_time.hpp"
#include "record.hpp"
#include "schemes.hpp"

#include <scree/error.hpp>
#include <scree/transport/fluxes.hpp>
#include <scree/transport/integrators.hpp>
#include <scree/transport/solver.hpp>
#include <scree/transport/staggered.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace scree::charts {

/// An initial-value problem on one grid, with its exact solution.
template <class Grid, class Law>
struct Case {
  static constexpr int D = Grid::dimension;
  static constexpr int N = transport::PointLawOf<Law>::num_components;

  Grid grid;
  Law law;
  transport::BoxBoundaries<D, N> boundaries;
  std::vector<double> start;                 ///< cell averages, num_sites x N, component fastest
  std::vector<double> exact;                 ///< of the first component at the end, one per site
  double duration;                           ///< [s]
  std::function<void()> before_run = [] {};  ///< called before each run
};

/// Faces through which something may pass: those on walls are closed and cost nothing.
template <class Grid, class Law>
[[nodiscard]] Index num_faces(const Case<Grid, Law>& problem) {
  const auto& lattice = problem.grid.lattice();
  Index faces = 0;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(Grid::dimension); ++axis) {
    Index along = lattice.count[axis];
    if (!lattice.is_periodic[axis]) {
      along -= 1;
      for (const auto& end : problem.boundaries[axis]) {
        along += std::visit([](const auto& boundary) { return boundary.is_closed ? 0 : 1; }, end);
      }
    }
    faces += along * (lattice.num_sites() / lattice.count[axis]);
  }
  return faces;
}

/// sum_i V_i |u_i - exact_i| of the first component.
template <class Grid, class Law>
[[nodiscard]] double l1_error(const Case<Grid, Law>& problem, const std::vector<double>& u) {
  double sum = 0;
  for (std::size_t i = 0; i < problem.exact.size(); ++i) {
    sum += std::abs(u[i * Case<Grid, Law>::N] - problem.exact[i]);
  }
  return sum * problem.grid.lattice().spacing.prod();
}

/// Runs one scheme on one problem put on the grid at one or more places. The error is the mean over the
/// places, the cost that at the first: a shock's error depends on where in its cell it stands.
/// @param evaluations of fluxes, in one step  @param make_solver makes a solver for a place
template <class Grid, class Law, class MakeSolver>
void measure(const std::vector<Case<Grid, Law>>& places, Index evaluations, const Effort& effort,
             Record& record, MakeSolver&& make_solver) {
  double error = 0;
  try {
    for (const auto& place : places) {
      auto solver = make_solver(place);
      std::vector<double> u;
      transport::Advance advance;
      const auto run = [&] {
        place.before_run();
        u = place.start;
        advance = solver.advance(u, place.duration);
      };
      if (&place == &places.front()) {
        record.cpu_seconds = best_cpu_seconds(run, effort);
        record.steps = advance.substeps;
        record.flux_evaluations = evaluations * advance.substeps;
      } else {
        run();
      }
      error += l1_error(place, u);
    }
    record.l1 = error / static_cast<double>(places.size());
  } catch (const RunError&) {  // states that cannot be: a result like any other
    record.cpu_seconds = std::numeric_limits<double>::quiet_NaN();
    record.l1 = std::numeric_limits<double>::quiet_NaN();
  }
}

/// Part of the promised CFL number that solvers take untold [-].
inline constexpr double usual_part = 0.9;

/// Runs one reconstruction with every flux and integrator that the library lists, each at the CFL number that
/// a solver takes unless told otherwise.
/// @param named a record with the names of problem, scheme and limiter  @param places the problem, see
/// measure()
template <class Grid, class Law, class R>
[[nodiscard]] std::vector<Record> run_reconstruction(const Record& named, const R& reconstruction,
                                                     const std::vector<Case<Grid, Law>>& places,
                                                     const Effort& effort) {
  std::vector<Record> records;
  transport::for_each_entry(transport::FluxList{}, [&]<class Flux>() {
    transport::for_each_entry(transport::IntegratorList{}, [&]<class Integrator>() {
      Record record = named;
      record.flux = Flux::name;
      record.integrator = Integrator::name;
      using Solver = transport::Solver<Grid, Law, R, Flux>;
      record.cfl = usual_part * Solver::promised_cfl(reconstruction);
      const auto num_stages = static_cast<Index>(Integrator::kept.size());
      measure(places, num_faces(places.front()) * num_stages, effort, record, [&](const auto& place) {
        return Solver{place.grid,
                      place.law,
                      reconstruction,
                      Integrator{},
                      {.cfl = record.cfl, .boundaries = place.boundaries}};
      });
      records.push_back(record);
    });
  });
  return records;
}

/// Runs the staggered scheme with every limiter. It asks a law for two fluxes per site and step, as a central
/// flux does per face and stage: that counts as one evaluation.
template <class Grid, class Law>
[[nodiscard]] std::vector<Record> run_staggered(const std::string& problem, Index n,
                                                const std::vector<Case<Grid, Law>>& places,
                                                const Effort& effort) {
  std::vector<Record> records;
  transport::for_each_entry(transport::LimiterList{}, [&]<class L>() {
    for_each_variant<L>([&](const L& limiter, const std::string& label) {
      using Solver = transport::StaggeredSolver<Law, L, Grid::dimension>;
      Record record{.problem = problem, .scheme = "staggered", .limiter = label, .n = n};
      record.cfl = usual_part * std::min(Solver::proven_cfl(limiter), Solver::largest_cfl());
      const auto& cells = places.front().grid.lattice();
      measure(places, cells.num_sites(), effort, record, [&](const auto& place) {
        return Solver{
            place.grid.lattice(), place.law, limiter, {.cfl = record.cfl, .boundaries = place.boundaries}};
      });
      records.push_back(record);
    });
  });
  return records;
}

/// Runs every scheme that the library has: reconstruction x limiter x flux x integrator over its lists; and
/// in one dimension, for laws that are the same everywhere, the staggered scheme x limiter.
/// @param places the problem, see measure()
template <class Grid, class Law>
[[nodiscard]] std::vector<Record> run_every_scheme(const std::string& problem, Index n,
                                                   const std::vector<Case<Grid, Law>>& places,
                                                   const Effort& effort) {
  std::vector<Record> records;
  for_each_reconstruction<Case<Grid, Law>::N>([&](const auto& reconstruction, const std::string& scheme,
                                                  const std::string& limiter) {
    const Record named{.problem = problem, .scheme = scheme, .limiter = limiter, .n = n};
    std::ranges::copy(run_reconstruction(named, reconstruction, places, effort), std::back_inserter(records));
  });
  if constexpr (Grid::dimension == 1 && transport::PointLaw<Law, 1>) {
    std::ranges::copy(run_staggered(problem, n, places, effort), std::back_inserter(records));
  }
  return records;
}

}  // namespace scree::charts
