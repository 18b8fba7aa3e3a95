#include "scree/run/leaving_text.hpp"

#include "scree/scene/dimensions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace scree::app {

namespace {

/// The cell that a place is in or, if it is outside, the nearest one; nothing if it is in the mesh.
template <int D>
[[nodiscard]] std::optional<Indices<D>> nearest_cell_of_outside(const CartesianGrid<D>& grid,
                                                                const Vector<D>& x) {
  Indices<D> cell{};
  bool is_outside = false;
  for (int d = 0; d < D; ++d) {
    const auto axis = static_cast<std::size_t>(d);
    const double place = (x[d] - grid.origin()[d]) / grid.spacing()[d];
    const Index last = grid.num_cells()[axis] - 1;
    if (!std::isfinite(place)) return std::nullopt;
    is_outside =
        is_outside || (!grid.is_periodic()[axis] && !(0 <= place && place <= static_cast<double>(last + 1)));
    cell[axis] = static_cast<Index>(std::clamp(std::floor(place), 0.0, static_cast<double>(last)));
  }
  return is_outside ? std::optional{cell} : std::nullopt;
}

}  // namespace

template <int D, int V>
std::string leaving_text(const mpm::Particles<D, V>& particles, const CartesianGrid<D>& grid, double time) {
  for (Index p = 0; p < particles.size(); ++p) {
    if (!(particles.mass.component(0)[p] > 0)) continue;
    Vector<D> x;
    for (int d = 0; d < D; ++d) x[d] = particles.position.component(d)[p];
    const auto cell = nearest_cell_of_outside(grid, x);
    if (!cell) continue;
    std::array<std::string, V> velocity;
    for (int i = 0; i < V; ++i) {
      velocity[static_cast<std::size_t>(i)] = fmt::format("{:.6g}", particles.velocity.component(i)[p]);
    }
    return fmt::format(
        ", past cell ({}), at t = {:.6g} s, with a velocity of ({}) m/s: make the mesh larger ([mesh] size), "
        "let it leave ([boundaries] leaving = \"absorb\") or throw it back (\"reflect\")",
        fmt::join(*cell, ", "), time, fmt::join(velocity, ", "));
  }
  return {};
}

#define SCREE_INSTANCE(D, V) \
  template std::string leaving_text(const mpm::Particles<D, V>&, const CartesianGrid<D>&, double);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::app
