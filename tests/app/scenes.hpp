#pragma once

#include "scree/scene.hpp"

#include <string>
#include <vector>

namespace scree::app::testing {

/// A scene that people run, by the name of its file, with some of its keys set otherwise.
[[nodiscard]] inline Scene scene_of(const std::string& name, const std::vector<std::string>& overrides = {}) {
  return read_scene(std::string{SCREE_TEST_SCENES} + "/" + name + ".toml", overrides).scene;
}

/// A small scene as text, for tests that spoil it.
[[nodiscard]] inline std::string small_scene() {
  return R"([mesh]
dimensions = 1
velocity_components = 2
size = [1.0]
cells = 8
[boundaries]
y_low = "no_slip"
y_high = "slip"
[material]
low = [0.0]
high = [0.75]
[rheology]
law = "size_dependent_newtonian"
viscosity_per_size = 1e6
bulk_modulus = 1e7
density = 1000
[grains]
diameters = [0.5e-3, 1e-3]
fractions = [0.5, 0.5]
[segregation]
closure = "shear_rate"
c = 0.05
remixing = 0.1
[time]
end = 0.01
)";
}

}  // namespace scree::app::testing
