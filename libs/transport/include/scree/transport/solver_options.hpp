#pragma once

#include <scree/blocks.hpp>
#include <scree/transport/discretisation.hpp>

#include <optional>

namespace scree::transport {

/// What an advance did.
struct Advance {
  int substeps = 0;          ///< steps taken
  double largest_speed = 0;  ///< at any face in any of them [m/s]
  double stable_dt = 0;      ///< longest that the last step could have been [s]
};

/// What a solver of N components on a kind of grid may be told.
template <class Grid, int N>
struct SolverOptions {
  std::optional<double> cfl = {};  ///< CFL number of its steps [-]; 9/10 of the promised one unless given
  Threads threads = {};            ///< one unless given
  typename BoundariesOf<Grid, N>::type boundaries = {};  ///< walls unless given
  double start_time = 0;                                 ///< [s]
  /// Steps that one advance may take. Unless given a thousand times as many as its first step asks for, and
  /// as there are cells from one end to the other: more means that steps have collapsed.
  std::optional<Index> max_steps = {};
};

}  // namespace scree::transport
