#pragma once

#include <span>
#include <string>
#include <string_view>

namespace scree::io::detail {

/// The candidate that `name` is most likely a misspelling of: fewest letters added, dropped, changed or
/// swapped, and at most a third of its letters; empty if none is that near.
[[nodiscard]] std::string_view nearest_name(std::string_view name,
                                            std::span<const std::string_view> candidates);

}  // namespace scree::io::detail
