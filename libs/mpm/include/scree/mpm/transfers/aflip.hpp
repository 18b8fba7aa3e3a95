#pragma once

#include <scree/error.hpp>
#include <scree/mpm/concepts.hpp>
#include <scree/parameter.hpp>

namespace scree::mpm {

/// The blend of Apic and FLIP: points pass on their velocity gradient, and take the nodes' increment of
/// velocity. Damps less than Apic; noise stays, as under FLIP.
/// @see Eq. (M31), Fei, Guo, Wu, Huang & Gao (2021), \cite fei2021
class Aflip {
 public:
  static constexpr std::string_view name = "aflip";
  static constexpr std::string_view summary =
      "affine, with a share of the nodal increment (share 0 is apic, 1 is affine FLIP)";
  static constexpr std::array<Parameter, 1> parameters{
      {{"increment_share", "-", "share of the nodal increment: 0 is APIC, 1 is affine FLIP", 0.99}}};
  static constexpr bool has_affine = true;
  static constexpr bool has_affine_gradient = true;
  static constexpr bool has_increment = true;

  /// @param increment_share 0 is APIC, 1 is affine FLIP [-].  @throws InputError outside [0, 1].
  explicit constexpr Aflip(double increment_share = 1) : increment_share_{increment_share} {
    require(0 <= increment_share && increment_share <= 1, "Aflip: increment_share must lie in [0, 1]");
  }
  [[nodiscard]] constexpr double increment_share() const noexcept { return increment_share_; }

 private:
  double increment_share_;
};
static_assert(TransferRule<Aflip>);

}  // namespace scree::mpm
