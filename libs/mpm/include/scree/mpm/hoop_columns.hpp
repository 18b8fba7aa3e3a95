#pragma once

#include <scree/mpm/particles.hpp>

#include <cstddef>
#include <optional>

namespace scree::mpm {

/// Columns of the direction round an axis of symmetry, which has no axis of the mesh: what laws read and
/// write as component zz.
struct HoopColumns {
  std::size_t rate;    ///< v_r/r [1/s]
  std::size_t stress;  ///< [Pa]
};

/// Adds them, all zero.
template <int D, int V>
HoopColumns add_hoop_columns(Particles<D, V>& particles) {
  return {particles.add_column({"hoop_rate", "v_r/r", "1/s"}, 1),
          particles.add_column({"hoop_stress", "sigma_tt", "Pa"}, 1)};
}

/// Those of a run round an axis; none of other runs.
template <int D, int V>
[[nodiscard]] std::optional<HoopColumns> hoop_columns_of(const Particles<D, V>& particles) {
  const auto rate = particles.column_named("hoop_rate");
  const auto stress = particles.column_named("hoop_stress");
  if (!rate || !stress) return std::nullopt;
  return HoopColumns{*rate, *stress};
}

}  // namespace scree::mpm
