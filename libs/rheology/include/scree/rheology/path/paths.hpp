#pragma once

#include <scree/rheology/path/stage.hpp>

#include <array>
#include <string_view>

namespace scree::rheology {

/// Pressure that grows alike in all directions: stress control on the three normals.
/// @param rate dp/dt [Pa/s], compression positive
[[nodiscard]] Controls isotropic_compression(double rate) noexcept;

/// Compression along y between walls: no strain along x and z.
/// @param rate -D_yy [1/s], compression positive, as in all that follow
[[nodiscard]] Controls oedometric(double rate) noexcept;

/// Compression along y while the stresses along x and z are held.
[[nodiscard]] Controls triaxial_drained(double rate) noexcept;

/// Compression along y at constant volume; the stress is the effective one.
[[nodiscard]] Controls triaxial_undrained(double rate) noexcept;

/// Shear of planes normal to y, along x, under a normal stress that is held: the volume follows.
/// @param rate dv_x/dy [1/s]
[[nodiscard]] Controls simple_shear_at_constant_pressure(double rate) noexcept;

/// Shear of planes normal to y, along x, and nothing else.
/// @param rate dv_x/dy [1/s]
[[nodiscard]] Controls simple_shear_at_constant_volume(double rate) noexcept;

/// Rigid rotation about z.  @param rate [rad/s]
[[nodiscard]] Controls rotation(double rate) noexcept;

/// A path that has a name.
struct NamedPath {
  std::string_view name;
  std::string_view summary;
  std::string_view unit;  ///< of the rate, SI
  Controls (*controls)(double rate) noexcept;
};

/// Every ready-made path. A new one is a line here: `scree path` can then name it, and every property test
/// runs every law on it.
inline constexpr std::array<NamedPath, 7> named_paths{{
    {"isotropic_compression", "pressure that grows alike in all directions", "Pa/s", &isotropic_compression},
    {"oedometric", "compression along y, no strain along x and z", "1/s", &oedometric},
    {"triaxial_drained", "compression along y, stresses along x and z held", "1/s", &triaxial_drained},
    {"triaxial_undrained", "compression along y at constant volume", "1/s", &triaxial_undrained},
    {"simple_shear_at_constant_pressure", "shear dv_x/dy, normal stress along y held", "1/s",
     &simple_shear_at_constant_pressure},
    {"simple_shear_at_constant_volume", "shear dv_x/dy and nothing else", "1/s",
     &simple_shear_at_constant_volume},
    {"rotation", "rigid rotation about z", "rad/s", &rotation},
}};

}  // namespace scree::rheology
