#pragma once

namespace scree::mpm {

/// Where the values of one node stand in its record of doubles: mass and momentum in the first four, and,
/// with increments, the force in a second four; without, it is added to the momentum at once.
struct NodeRecord {
  int num_velocities;
  bool has_increment;

  static constexpr int mass = 0;      ///< [kg]
  static constexpr int momentum = 1;  ///< [kg m/s], after the update the velocity [m/s]
  [[nodiscard]] static constexpr int increment() noexcept { return 4; }  ///< [N], then [m/s]
  [[nodiscard]] constexpr int size() const noexcept { return has_increment ? 8 : 4; }
};

}  // namespace scree::mpm
