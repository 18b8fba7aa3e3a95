#pragma once

#include "../every_scheme.hpp"

#include <scree/transport/grids/cartesian.hpp>
#include <scree/transport/laws/euler.hpp>

namespace scree::charts {

using GasCase = Case<transport::Cartesian<1>, transport::Euler<1>>;

/// The schemes that reconstruct primitive variables, on a gas in one dimension.
[[nodiscard]] std::vector<Record> run_gas_in_primitives(const std::string& problem, Index n,
                                                        const GasCase& start, const Effort& effort);

/// Every scheme on a gas in one dimension.
[[nodiscard]] std::vector<Record> run_gas(const std::string& problem, Index n, const GasCase& start,
                                          const Effort& effort);

/// A gas between open ends, without states yet. A run that asks for more than any number of steps that makes
/// sense fails: near vacuum a scheme can cut its steps almost without end.
[[nodiscard]] GasCase between_open_ends(const Lattice<1>& cells, double duration);

/// Density, velocity and pressure of a gas.
struct Gas {
  double density;   ///< [kg/m^3]
  double velocity;  ///< [m/s]
  double pressure;  ///< [Pa]
};

/// Appends the conserved state of one cell.
inline void append(std::vector<double>& states, const Gas& gas) {
  const auto u = transport::Euler<1>{}.state(gas.density, Vector<1>{gas.velocity}, gas.pressure);
  states.insert(states.end(), u.begin(), u.end());
}

}  // namespace scree::charts
