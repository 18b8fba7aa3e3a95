#pragma once

#include "scree/scene/scene.hpp"

#include <scree/io/toml_reader.hpp>

#include <optional>

namespace scree::app {

/// The grains of a scene, from its table [grains]; nothing if they are faulty.
[[nodiscard]] std::optional<grainsize::Distribution> read_grains(const io::TomlTable& table);

/// What the law of a scene asks of their mix, from the same table.
/// @param scene of which the law and the grains have been read
[[nodiscard]] MixtureScene read_mixture(const io::TomlTable& table, const Scene& scene);

}  // namespace scree::app
