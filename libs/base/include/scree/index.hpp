#pragma once

#include <cstddef>

namespace scree {

/// Signed everywhere: differences of indices are as common as indices.
using Index = std::ptrdiff_t;

}  // namespace scree
