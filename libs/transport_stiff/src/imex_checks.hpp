#pragma once

#include <scree/tensor.hpp>
#include <scree/transport_stiff/imex_problem.hpp>

#include <span>

namespace scree::transport::detail {

/// @throws InputError naming what is out of range or does not fit.
void require_valid(Index num_values, const ImexProblem& problem, const ImexOptions& options);

/// @throws InputError for a wrong length, or for times that are not finite or run backwards.
void require_advance(std::size_t num_values, std::size_t expected, double time, double duration);

/// @throws RunError if a step is lost in the round-off of the times it leads between [s], or is not a number.
void require_progress(double step, double time, double duration);

/// @throws RunError naming the first value that is not finite.
void require_finite(std::span<const double> u, double time);

}  // namespace scree::transport::detail
