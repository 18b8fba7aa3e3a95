#pragma once

#include <scree/error.hpp>
#include <scree/transport/concepts.hpp>
#include <scree/transport/detail/place.hpp>

namespace scree::transport::detail {

/// Checks the states of all cells that hold something, for laws that have states which cannot be.
/// @throws Fault (InputError or RunError) with the first such cell, its position and its state.
template <class Fault, class Rates, class Storage>
void require_admissible(const Rates& rates, const Storage& states) {
  const auto& problem = rates.problem();
  if constexpr (HasAdmissibleStates<std::remove_cvref_t<decltype(problem.law)>>) {
    for (Index site = 0; site < rates.num_sites(); ++site) {
      const auto state = states[site];
      if (problem.law.is_admissible(state) || !rates.holds(site)) continue;
      throw Fault{"transport: the state " + tuple_text(state) + " is not admissible, at " +
                  place_in(problem.grid, site)};
    }
  }
}

}  // namespace scree::transport::detail
