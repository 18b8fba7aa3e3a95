#include "../problems.hpp"
#include "gas.hpp"
#include "lines.hpp"

#include <scree/transport/fluxes/kurganov_noelle_petrova.hpp>

#include <cmath>

namespace scree::charts {
namespace {

constexpr Index fine = 12800;
constexpr Index quick_fine = 800;

/// A shock of Mach 3 at x = -4 that runs to the right into density waves 1 + 0.2 sin 5x.
GasCase shock_and_waves(Index n) {
  GasCase problem = between_open_ends(line(n, -5, 5, false), 1.8);
  const auto waves = averages(problem.grid.lattice(), [](double x) { return x - 0.2 / 5 * std::cos(5 * x); });
  for (Index i = 0; i < n; ++i) {
    const bool is_behind = 10 * (i + 1) <= n;  // of the shock
    append(problem.start,
           is_behind ? Gas{3.857143, 2.629369, 10.33333} : Gas{waves[static_cast<std::size_t>(i)], 0, 1});
  }
  return problem;
}

/// Densities of our own run on a fine grid.
std::vector<double> reference(Index n) {
  GasCase problem = shock_and_waves(n);
  transport::Solver solver{problem.grid,
                           problem.law,
                           transport::PiecewiseLinear{transport::Minmod{2}},
                           transport::SspRk2{},
                           {.boundaries = problem.boundaries},
                           transport::KurganovNoellePetrova{}};
  problem.before_run();
  solver.advance(problem.start, problem.duration);
  std::vector<double> densities;
  for (std::size_t i = 0; i < problem.start.size(); i += 3) densities.push_back(problem.start[i]);
  return densities;
}

/// Means over blocks of cells.
std::vector<double> coarsened(const std::vector<double>& u, Index n) {
  const std::size_t block = u.size() / static_cast<std::size_t>(n);
  std::vector<double> means(static_cast<std::size_t>(n), 0.0);
  for (std::size_t i = 0; i < u.size(); ++i) means[i / block] += u[i] / static_cast<double>(block);
  return means;
}

}  // namespace

std::vector<Record> shu_osher(const Extent& extent) {
  const auto densities = reference(extent.is_quick ? quick_fine : fine);
  std::vector<Record> records;
  for (const Index n : doublings(100, 5, extent)) {
    GasCase problem = shock_and_waves(n);
    problem.exact = coarsened(densities, n);
    std::ranges::copy(run_gas("shu_osher", n, problem, extent.effort), std::back_inserter(records));
  }
  return records;
}

}  // namespace scree::charts
