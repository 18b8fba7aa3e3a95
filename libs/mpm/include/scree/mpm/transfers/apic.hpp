#pragma once

#include <scree/mpm/concepts.hpp>

namespace scree::mpm {

/// Affine particle-in-cell: a point carries the velocity and its gradient, and passes both on. Keeps linear
/// and angular momentum, and any affine velocity field.
/// @see Eq. (M8), Jiang, Schroeder, Selle, Teran & Stomakhin (2015), \cite jiang2015
struct Apic {
  static constexpr std::string_view name = "apic";
  static constexpr std::string_view summary =
      "affine particle-in-cell: keeps affine velocities and angular momentum";
  static constexpr bool has_affine = true;
  static constexpr bool has_affine_gradient = true;
  static constexpr bool has_increment = false;
  [[nodiscard]] static constexpr double increment_share() noexcept { return 0; }
};
static_assert(TransferRule<Apic>);

}  // namespace scree::mpm
