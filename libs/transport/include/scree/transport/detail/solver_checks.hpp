#pragma once

#include <scree/tensor.hpp>

#include <cstddef>
#include <optional>

namespace scree::transport::detail {

/// @throws InputError unless 0 < cfl <= promised.
void require_cfl(double cfl, double promised);

/// @throws InputError unless there are num_sites x num_components values.
void require_size(std::size_t num_values, Index num_sites, int num_components);

/// @throws InputError unless the duration is zero or positive, and finite.
void require_duration(double duration);

/// @throws InputError unless the time is finite.
void require_start_time(double time);

/// @throws InputError if a number of steps is given and is not positive.
void require_max_steps(const std::optional<Index>& max_steps);

}  // namespace scree::transport::detail
