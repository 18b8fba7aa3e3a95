#pragma once

#include "scree/scene/scene.hpp"

#include <string>
#include <vector>

namespace scree::app::testing {

/// A scene that people run, by the name of its file, with some of its keys set otherwise.
[[nodiscard]] inline Scene scene_of(const std::string& name, const std::vector<std::string>& overrides = {}) {
  return read_scene(std::string{SCREE_TEST_SCENES} + "/" + name + ".toml", overrides).scene;
}

/// A text with its first `part` put otherwise.
[[nodiscard]] inline std::string with(std::string text, const std::string& part, const std::string& instead) {
  return text.replace(text.find(part), part.size(), instead);
}

/// Takes a simulation to a time [s]. At none of its frames until then may waves grow in the next step.
template <class Run>
void advance_to(double time, Run& run) {
  while (run.clock.time < time) {
    if (run.step()) run.require_stable();
  }
}

/// Takes it to its end.
template <class Run>
void advance_to_end(Run& run) {
  advance_to(run.scene().end, run);
}

/// Tables of a material so viscous that it moves as a block, and of the time that it has.
[[nodiscard]] inline std::string viscous_block() {
  return R"([rheology]
law = "newtonian"
viscosity = 2e4
bulk_modulus = 1e7
density = 1000
[numerics]
maximum_dt = 1e-4
[time]
end = 100
)";
}

/// Tables of scenes in the plane, one below the other: a channel of 1 m on a smooth floor, open at both ends;
[[nodiscard]] inline std::string open_channel() {
  return R"([mesh]
dimensions = 2
size = [1.0, 0.5]
cells = 10
[boundaries]
x_low = "open"
x_high = "open"
y_low = "slip"
y_high = "open"
leaving = "absorb"
)";
}

/// a stream that enters it at 1 m/s, 0.1 m deep and at the start as long;
[[nodiscard]] inline std::string stream_of_1_m_per_s() {
  return R"([[inflow]]
low = [0.0, 0.0]
high = [0.1, 0.1]
velocity = [1.0, 0.0]
points_per_cell = 2
)";
}

/// and the fluid that it is of.
[[nodiscard]] inline std::string fluid_of_streams() {
  return R"([rheology]
law = "newtonian"
viscosity = 1
bulk_modulus = 1e5
density = 1000
)";
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
