#pragma once

#include "lines.hpp"

#include <scree/transport/fluxes.hpp>
#include <scree/transport/laws/euler.hpp>
#include <scree/transport/solver.hpp>

#include <vector>

namespace scree::transport::test {

/// A flow on a line.
struct Flow {
  double low;   // [m]
  double high;  // [m]
  double time;  // [s]
  AnyBoundary<1, 3> ends;
  std::vector<double> (*start)(Index n);
};

/// Density 1 at rest; pressure 1000, 0.01 and 100 between walls.
inline std::vector<double> blast_start(Index n) {
  const Euler<1> gas;
  std::vector<double> u;
  for (Index i = 0; i < n; ++i) {
    const double pressure = i < n / 10 ? 1000 : i < 9 * n / 10 ? 0.01 : 100;
    const auto cell = gas.state(1, Vector<1>{0.0}, pressure);
    u.insert(u.end(), cell.begin(), cell.end());
  }
  return u;
}

/// A shock of Mach 3 that runs into 1 + sin(5 x)/5.
inline std::vector<double> shock_in_wave_start(Index n) {
  const Euler<1> gas;
  const auto density = averages(line(n, -5, 5), [](double x) { return x - 0.04 * std::cos(5 * x); });
  std::vector<double> u;
  for (Index i = 0; i < n; ++i) {
    const auto cell = i < n / 10 ? gas.state(3.857143, Vector<1>{2.629369}, 10.33333)
                                 : gas.state(density[static_cast<std::size_t>(i)], Vector<1>{0.0}, 1);
    u.insert(u.end(), cell.begin(), cell.end());
  }
  return u;
}

inline const Flow blast{0, 1, 0.038, Reflecting{}, blast_start};
inline const Flow shock_in_wave{-5, 5, 1.8, Outflow{}, shock_in_wave_start};

/// Densities at the end.
template <class R, class F>
std::vector<double> densities(const Flow& flow, Index n, const R& reconstruction, const F& flux) {
  auto u = flow.start(n);
  Solver<Cartesian<1>, Euler<1>, R, F> solver{
      Cartesian<1>{line(n, flow.low, flow.high, false)},      Euler<1>{}, reconstruction, SspRk2{},
      {.cfl = 0.4, .boundaries = {{{flow.ends, flow.ends}}}}, flux};
  solver.advance(u, flow.time);
  std::vector<double> result;
  for (std::size_t i = 0; i < u.size(); i += 3) result.push_back(u[i]);
  return result;
}

}  // namespace scree::transport::test
