#pragma once

#include "scree/scene/scene.hpp"

#include <scree/io/toml_reader.hpp>

#include <vector>

namespace scree::app {

/// A stream that enters each, from [[inflow]].
/// @param scene of which the mesh, the material, the grains and the ends of the axes have been read
[[nodiscard]] std::vector<InflowScene> read_inflows(const std::vector<io::TomlTable>& tables,
                                                    const Scene& scene);

/// A box each that takes away what enters it, from [[outflow]].
/// @param scene of which the mesh has been read
[[nodiscard]] std::vector<OutflowScene> read_outflows(const std::vector<io::TomlTable>& tables,
                                                      const Scene& scene);

}  // namespace scree::app
