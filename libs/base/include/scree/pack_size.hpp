#pragma once

#include <scree/index.hpp>

namespace scree {

/// Points of a block come in whole packs of this many, so that no instruction set has points left over.
inline constexpr Index pack_size = 8;

}  // namespace scree
