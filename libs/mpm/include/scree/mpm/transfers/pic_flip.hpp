#pragma once

#include <scree/error.hpp>
#include <scree/mpm/concepts.hpp>
#include <scree/parameter.hpp>

namespace scree::mpm {

/// The blend of FLIP (points take the nodes' increment of velocity: no damping, noise stays) and PIC (points
/// take the nodes' velocity: strong damping, spin is lost).
/// @see Eq. (M9), Brackbill & Ruppel (1986), \cite brackbill1986
class PicFlip {
 public:
  static constexpr std::string_view name = "pic_flip";
  static constexpr std::string_view summary =
      "blend of nodal velocity (PIC, share 0) and nodal increment (FLIP, share 1)";
  static constexpr std::array<Parameter, 1> parameters{
      {{"increment_share", "-", "share of the nodal increment: 0 is PIC, 1 is FLIP", 0.99}}};
  static constexpr bool has_affine = false;
  static constexpr bool has_affine_gradient = false;
  static constexpr bool has_increment = true;

  /// @param increment_share 0 is PIC, 1 is FLIP [-].  @throws InputError outside [0, 1].
  explicit constexpr PicFlip(double increment_share = 1) : increment_share_{increment_share} {
    require(0 <= increment_share && increment_share <= 1, "PicFlip: increment_share must lie in [0, 1]");
  }
  [[nodiscard]] constexpr double increment_share() const noexcept { return increment_share_; }

 private:
  double increment_share_;
};
static_assert(TransferRule<PicFlip>);

}  // namespace scree::mpm
