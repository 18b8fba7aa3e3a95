#pragma once

#include <scree/grainsize/closures.hpp>

#include <array>
#include <variant>

namespace scree::test {

/// One of each closure in the list: what is asked of every closure runs over these.
[[nodiscard]] inline std::array<grainsize::AnyClosure, std::variant_size_v<grainsize::AnyClosure>>
every_closure() {
  return {grainsize::ShearRate{0.01}, grainsize::SizeWeightedShearRate{0.01, 1e-3}, grainsize::Gravity{0.5}};
}

}  // namespace scree::test
