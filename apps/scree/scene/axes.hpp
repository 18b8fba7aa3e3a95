#pragma once

#include <array>
#include <string_view>
#include <vector>

namespace scree::app {

/// Which axis of space (x along the flow, y normal to the base, z across) each component of a D-dimensional
/// run lies along: component d < D of a position, component i < V of a velocity. A column (D = 1) is normal
/// to the base, and its second velocity component runs along it.
[[nodiscard]] std::array<int, 3> axes_of_components(int dimensions);

/// The component that is normal to the base.
[[nodiscard]] int normal_component(int dimensions);
/// The velocity component along the flow; -1 if a run of `velocity_components` has none.
[[nodiscard]] int flow_component(int dimensions, int velocity_components);

/// "x", "y" or "z" for each axis of a D-dimensional mesh.
[[nodiscard]] std::vector<std::string_view> axis_names(int dimensions);

}  // namespace scree::app
