#pragma once

#include "toml_state.hpp"

#include <string>
#include <string_view>

namespace scree::io::detail {

/// Whether a key needs no quotes.
[[nodiscard]] bool is_bare_key(std::string_view key);

/// The tables with all changes as TOML: keys in the order of the file, values as they are written there.
[[nodiscard]] std::string print(const TomlState& state);

}  // namespace scree::io::detail
