#pragma once

#include "scheme.hpp"

#include <string>
#include <vector>

namespace scree::charts {

/// One scheme on one mesh: what it costs, and how far it is from the reference.
struct Run {
  std::string problem{};
  Scheme scheme{};
  Index cells = 0;  ///< along an axis
  double cpu_seconds = 0;
  double error = 0;  ///< [-], of each problem its own; NaN for a run that ended early
};

/// A square that swings along both axes, large strains, 8 to 32 cells along an axis (quick: 8): largest root
/// mean square of distances from the exact places over the amplitude.  Eqs. (M81), (M82)
[[nodiscard]] std::vector<Run> swing(const Scheme& scheme, bool is_quick);
/// A ring that turns to and fro, large shear, across the cells of the mesh, 16 to 64 cells; errors over
/// its largest way.  Eqs. (M83), (M84)
[[nodiscard]] std::vector<Run> turning_ring(const Scheme& scheme, bool is_quick);
/// A column of grains twice as high as wide that collapses, 6 to 24 cells along its mesh (quick: 6): the
/// share of the mass that lies elsewhere than by quadratic splines with APIC on a mesh four times as fine.
[[nodiscard]] std::vector<Run> collapse(const Scheme& scheme, bool is_quick);

}  // namespace scree::charts
