#include "scree/assemble/make_stages.hpp"
#include "scree/assemble/overlaps.hpp"
#include "scree/run/run.hpp"
#include "scree/run/simulation.hpp"
#include "scree/run/stability.hpp"
#include "scree/run/well_posedness.hpp"
#include "scree/scene/with_dimensions.hpp"

#include <fmt/format.h>

namespace scree::app {

std::string cost_of(const Scene& scene) {
  std::string text = with_dimensions(scene, [&](auto dimensions, auto components) {
    const Simulation<dimensions(), components()> simulation{scene, {1}};
    const auto& state = simulation.state;
    const mpm::TimeStep step = simulation.next_step();
    const double node_bytes =
        static_cast<double>(state.nodes.num_nodes() * state.nodes.record().size()) * sizeof(double);
    const double sort_bytes = 3 * sizeof(double) * static_cast<double>(state.particles.size());
    const double steps = scene.end / step.dt;
    const double megabyte = 1e6;
    std::string lines = fmt::format(
        "points   {} ({} bytes each)\n"
        "cells    {}\n"
        "dt       {:.3e} s at the start, bound by the {} limit\n"
        "steps    about {:.3g}, {:.3g} point updates\n"
        "memory   {:.3g} MB\n",
        simulation.num_points(), state.particles.bytes_per_particle(), simulation.grid().cells().num_sites(),
        step.dt, mpm::limit_names[static_cast<std::size_t>(step.limit)], steps,
        steps * static_cast<double>(simulation.num_points()),
        (node_bytes + static_cast<double>(state.particles.held_bytes()) + sort_bytes) / megabyte);
    const std::string few = simulation.too_few_points();
    if (!few.empty()) lines += "warning: " + few + "\n";
    const std::string soft = softness_warning(simulation);
    if (!soft.empty()) lines += "warning: " + soft + "\n";
    const std::string walls =
        wall_under_ground_warning(scene, simulation.grid(), ground_of<dimensions()>(scene));
    if (!walls.empty()) lines += "warning: " + walls + "\n";
    return lines;
  });
  for (const std::string& warning : {ill_posedness_warning(scene), one_mean_warning(scene)}) {
    if (!warning.empty()) text += "warning: " + warning + "\n";
  }
  return text;
}

}  // namespace scree::app
