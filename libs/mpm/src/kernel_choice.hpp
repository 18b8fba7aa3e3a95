#pragma once

#include <scree/error.hpp>
#include <scree/instruction_set.hpp>

#include <algorithm>
#include <string>

namespace scree::mpm::detail {

/// @throws InputError naming `wanted_by` if this build or this machine has no kernels for `set`.
inline void require_kernels(InstructionSet set, const std::string& wanted_by) {
  const auto sets = instruction_sets();
  require(std::find(sets.begin(), sets.end(), set) != sets.end(), wanted_by + ": there are no kernels for " +
                                                                      std::string{name_of(set)} +
                                                                      " in this build or on this machine");
}

}  // namespace scree::mpm::detail
