#pragma once

#include <scree/mpm/concepts.hpp>

namespace scree::mpm {

/// Taylor particle-in-cell: as Apic, but the gradient that a point carries is that of the shape functions,
/// the one its law and its forces see. Keeps linear momentum and any affine velocity field; angular momentum
/// from points to nodes, but back only under hat functions.
/// @see Eq. (M30), Nakamura, Matsumura & Mizutani (2023), \cite nakamura2023
struct Tpic {
  static constexpr std::string_view name = "tpic";
  static constexpr std::string_view summary =
      "Taylor particle-in-cell: affine, by the gradients of the shape functions";
  static constexpr bool has_affine = true;
  static constexpr bool has_affine_gradient = false;
  static constexpr bool has_increment = false;
  [[nodiscard]] static constexpr double increment_share() noexcept { return 0; }
};
static_assert(TransferRule<Tpic>);

}  // namespace scree::mpm
