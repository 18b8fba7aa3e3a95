#pragma once

#include <scree/tensor.hpp>

#include <cstddef>

namespace scree::rheology::detail {

/// An index as the containers of the standard library count.
constexpr std::size_t at(Index i) noexcept {
  return static_cast<std::size_t>(i);
}

}  // namespace scree::rheology::detail
