#include <scree/error.hpp>
#include <scree/transport/detail/solver_checks.hpp>

#include <cmath>
#include <sstream>
#include <string>

namespace scree::transport::detail {

void require_cfl(double cfl, double promised) {
  if (0 < cfl && cfl <= promised) return;
  std::ostringstream text;
  text << "Solver: the CFL number is " << cfl << ": must lie in (0, " << promised
       << "], as the scheme promises no more";
  throw InputError{text.str()};
}

void require_size(std::size_t num_values, Index num_sites, int num_components) {
  if (num_values == static_cast<std::size_t>(num_sites * num_components)) return;
  std::ostringstream text;
  text << "Solver: " << num_values << " values for " << num_sites << " sites x " << num_components
       << " components";
  throw InputError{text.str()};
}

void require_duration(double duration) {
  if (duration >= 0 && std::isfinite(duration)) return;
  std::ostringstream text;
  text << "Solver: the duration is " << duration << " s: must be zero or positive, and finite";
  throw InputError{text.str()};
}

void require_start_time(double time) {
  if (std::isfinite(time)) return;
  std::ostringstream text;
  text << "Solver: the start time is " << time << " s: must be finite";
  throw InputError{text.str()};
}

void require_max_steps(const std::optional<Index>& max_steps) {
  if (!max_steps || *max_steps >= 1) return;
  throw InputError{"Solver: max_steps is " + std::to_string(*max_steps) + ": must be at least 1"};
}

}  // namespace scree::transport::detail
