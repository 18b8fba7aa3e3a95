#pragma once

#include "lines.hpp"

#include <scree/transport/fluxes.hpp>
#include <scree/transport/laws/euler.hpp>
#include <scree/transport/solver.hpp>

#include <exact_riemann.hpp>

#include <vector>

namespace scree::transport::test {

using scree::testing::Gas;
using scree::testing::GasRiemann;

/// Two gases, left and right of x = 0, and the time of interest [s].
struct GasProblem {
  Gas left;
  Gas right;
  double time;
};

inline const GasProblem sod{{1, 0, 1}, {0.125, 0, 0.1}, 0.2};
inline const GasProblem fans_123{{1, -2, 0.4}, {1, 2, 0.4}, 0.15};
inline const GasProblem collision{{5.99924, 19.5975, 460.894}, {5.99242, -6.19633, 46.0950}, 0.035};

inline std::vector<double> conserved_line(const GasProblem& problem, Index n) {
  const Euler<1> law;
  std::vector<double> u;
  for (Index i = 0; i < n; ++i) {
    const Gas& gas = i < n / 2 ? problem.left : problem.right;
    const auto cell = law.state(gas.density, Vector<1>{gas.velocity}, gas.pressure);
    u.insert(u.end(), cell.begin(), cell.end());
  }
  return u;
}

inline SolverOptions<Cartesian<1>, 3> open_ends() {
  SolverOptions<Cartesian<1>, 3> options;
  options.boundaries = {{{Outflow{}, Outflow{}}}};
  return options;
}

/// L1 error of the density of any n cells on [-1/2, 1/2].
inline double density_error(const std::vector<double>& u, const GasProblem& problem) {
  const auto n = static_cast<Index>(u.size() / 3);
  const double dx = 1.0 / static_cast<double>(n);
  const auto exact = scree::testing::fan_averages(GasRiemann{problem.left, problem.right}, problem.time, n,
                                                  -0.5, dx, [](const Gas& gas) { return gas.density; });
  double sum = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) sum += std::abs(u[3 * i] - exact[i]) * dx;
  return sum;
}

/// That of a scheme at CFL 0.4, [-1/2, 1/2] with open ends.
template <class R, class F>
double density_error(const GasProblem& problem, Index n, const R& reconstruction, const F& flux) {
  auto u = conserved_line(problem, n);
  auto options = open_ends();
  options.cfl = 0.4;
  Solver<Cartesian<1>, Euler<1>, R, F> solver{
      Cartesian<1>{line(n, -0.5, 0.5, false)}, Euler<1>{}, reconstruction, SspRk2{}, options, flux};
  solver.advance(u, problem.time);
  return density_error(u, problem);
}

}  // namespace scree::transport::test
