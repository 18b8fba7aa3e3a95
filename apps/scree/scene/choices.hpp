#pragma once

#include "scree/scene/scene.hpp"

#include <array>
#include <cstddef>
#include <string_view>

namespace scree::app {

/// A word that a key of a scene may be.
struct Choice {
  std::string_view name;
  std::string_view summary;
};

/// The words that are no model of a library: what reads scenes takes these, and `scree list` tells them.
namespace choices {

inline constexpr std::array<Choice, 2> symmetries{
    {{"plane", "a cut through what goes on across it"}, {"axisymmetric", "flow round the axis x = 0"}}};
inline constexpr std::array<Choice, 2> axis_kinds{
    {{"walls", "a wall at each end, or none, \"open\""}, {"periodic", "one end is the other"}}};
inline constexpr std::array<Choice, 3> leavings{{{"stop", "the run ends with an error"},
                                                 {"absorb", "it is removed and counted"},
                                                 {"reflect", "it is thrown back"}}};
inline constexpr std::array<Choice, 2> holds{
    {{"pushes", "material may leave the wall"}, {"pushes_and_pulls", "material may not leave the wall"}}};
inline constexpr std::array<Choice, 2> plain_contacts{
    {{mpm::Sticks::name, "material moves with it"}, {mpm::Slides::name, "no friction"}}};
inline constexpr std::array<Choice, 4> terrain_surfaces{
    {{"plane", "through a point, across a normal (2D, 3D)"},
     {"profile", "heights at equal distances (2D)"},
     {"raster", "a map of heights in the ESRI ASCII format (3D)"},
     {"stl", "triangles, on a map (3D)"}}};
inline constexpr std::array<Choice, 3> body_surfaces{{{"ball", "solid, or hollow round the material"},
                                                      {"plane", "through a point, across a normal"},
                                                      {"stl", "triangles, in coordinates of the mesh (3D)"}}};
inline constexpr std::array<Choice, 4> region_shapes{
    {{"box", "between two corners"},
     {"polygon", "of x and y; in 3D a prism along z (2D, 3D)"},
     {"layer", "between two heights, above the ground"},
     {"release", "on the ground, as deep as a map says (3D)"}}};
inline constexpr std::array<Choice, 2> layouts{
    {{"regular", "in the middle of their shares of a cell"}, {"random", "anywhere in them"}}};
inline constexpr std::array<Choice, 3> orders{
    {{mpm::order_names[0], "last, by the velocities that forces have just changed"},
     {mpm::order_names[1], "last, by those that the points' new momentum makes"},
     {mpm::order_names[2], "first, before forces change them"}}};
inline constexpr std::array<Choice, 3> viscosity_schemes{
    {{"explicit", "with the rest of the stress"},
     {"implicit", "solved for on the nodes, by the library rheology_stiff"},
     {"auto", "implicit where the explicit step would be much shorter"}}};
inline constexpr std::array<Choice, 4> distributions{{{"classes", "sizes, and their fractions"},
                                                      {"histogram", "edges of classes, and their fractions"},
                                                      {"log_normal", "by volume, cut at both ends"},
                                                      {"power_law", "by number, cut at both ends"}}};
inline constexpr std::array<Choice, 2> control_volumes{
    {{"cells", "those of the mesh"}, {"nodes", "round its nodes"}}};
inline constexpr std::array<Choice, 2> carried_maps{
    {{"exchange", "keeps fractions within [0, 1]"},
     {"increments", "the paper's, which lets points leave [0, 1]"}}};

}  // namespace choices

/// The names of choices, in their order.
template <std::size_t N>
[[nodiscard]] constexpr std::array<std::string_view, N> names_of(
    const std::array<Choice, N>& choices) noexcept {
  std::array<std::string_view, N> names;
  for (std::size_t i = 0; i < N; ++i) names[i] = choices[i].name;
  return names;
}

}  // namespace scree::app
