#include "scree/scene/axes.hpp"

namespace scree::app {

std::array<int, 3> axes_of_components(int dimensions) {
  if (dimensions == 1) return {1, 0, 2};
  return {0, 1, 2};
}

int normal_component(int dimensions) {
  return dimensions == 1 ? 0 : 1;
}

int flow_component(int dimensions, int velocity_components) {
  if (dimensions > 1) return 0;
  return velocity_components > 1 ? 1 : -1;
}

std::vector<std::string_view> axis_names(int dimensions) {
  constexpr std::array<std::string_view, 3> names{"x", "y", "z"};
  std::vector<std::string_view> result;
  result.reserve(static_cast<std::size_t>(dimensions));
  for (int d = 0; d < dimensions; ++d) {
    result.push_back(
        names[static_cast<std::size_t>(axes_of_components(dimensions)[static_cast<std::size_t>(d)])]);
  }
  return result;
}

}  // namespace scree::app
