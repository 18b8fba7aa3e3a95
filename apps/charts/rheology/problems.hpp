#pragma once

#include "../cpu_time.hpp"
#include "run.hpp"

#include <vector>

namespace scree::charts {

/// How much of a problem is run.
struct Extent {
  bool is_quick = false;  ///< few parameters and steps
  Effort effort;
};

/// Start-up of a viscous layer on a slope, parameter viscosity [Pa s], against the exact solution on its
/// nodes.
[[nodiscard]] std::vector<Run> newtonian_layer(const Extent& extent);
/// The same of Bingham's fluid, parameter regularisation time [s], against CVODE with ten digits.
[[nodiscard]] std::vector<Run> bingham_layer(const Extent& extent);
/// A point of GranularElastoviscoplastic that is sheared, then sheared back, against CVODE with ten digits.
[[nodiscard]] std::vector<Run> granular_point(const Extent& extent);
/// The same of ElasticHerschelBulkley.
[[nodiscard]] std::vector<Run> yield_stress_point(const Extent& extent);

}  // namespace scree::charts
