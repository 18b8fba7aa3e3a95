#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace scree::app {

/// Of the entries of a checkpoint and their meaning.
inline constexpr std::int64_t checkpoint_version = 6;

/// The entry that holds a column of the points.
[[nodiscard]] inline std::string entry_of(std::string_view column) {
  return "column_" + std::string{column};
}

}  // namespace scree::app
