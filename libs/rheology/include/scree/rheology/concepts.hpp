#pragma once

#include <scree/law_block.hpp>
#include <scree/rheology/block_kernel.hpp>
#include <scree/rheology/parameters.hpp>
#include <scree/wall_law.hpp>

#include <concepts>
#include <cstddef>
#include <string_view>
#include <type_traits>

namespace scree::rheology {

/// A constitutive law as the list of laws holds it: the contract of `ConstitutiveLaw`, an aggregate whose
/// parameters are set by name, the density of the unloaded material [kg/m^3] among them, and a description of
/// itself from which scenes are read and tests are made.
template <class Law>
concept DescribedLaw = ConstitutiveLaw<Law> && std::is_aggregate_v<Law> && requires(const Law law) {
  { law.density } -> std::convertible_to<double>;
  { Law::summary } -> std::convertible_to<std::string_view>;
  { *Law::parameters.begin() } -> std::convertible_to<LawParameter<Law>>;
};

/// The friction of a wall as the list of them holds it: the contract of `WallLaw`, described as laws are.
template <class Law>
concept DescribedWall = WallLaw<Law> && std::is_aggregate_v<Law> && requires {
  { Law::summary } -> std::convertible_to<std::string_view>;
  { *Law::parameters.begin() } -> std::convertible_to<LawParameter<Law>>;
};

/// Whether grains looser than the law's `density` do not touch and bear no stress, Eq. (R5): so it is, unless
/// a law that presses at any density (a gas of grains, a soil under an initial pressure) says `static
/// constexpr bool disconnects = false`.
template <class Law>
inline constexpr bool disconnects = [] {
  if constexpr (requires { Law::disconnects; }) {
    return Law::disconnects;
  } else {
    return true;
  }
}();

/// Whether a law's memory begins with the components xx, yy, zz, xy, xz and yz of a tensor of trace 0: so it
/// does if the law says `static constexpr bool remembers_deviator = true`.
template <class Law>
inline constexpr bool remembers_deviator = [] {
  if constexpr (requires { Law::remembers_deviator; }) {
    return Law::remembers_deviator;
  } else {
    return false;
  }
}();

/// How many points a law's kernel computes at once, where registers are as wide: four, unless the law was
/// measured to be faster in a whole pack of eight and says `static constexpr std::size_t most_lanes = 8`.
/// Roots and quotients are half as fast in registers twice as wide; exp, log and pow (`elementary`) are not.
template <class Law>
inline constexpr std::size_t most_lanes = [] {
  if constexpr (requires { Law::most_lanes; }) {
    return Law::most_lanes;
  } else {
    return std::size_t{4};
  }
}();

/// A law that can tell where its equations are ill-posed: C > 0.  Eq. (R15)
template <class Law>
concept HasStabilityNumber = requires(const Law law, const Deformation<double>& deformation,
                                      const typename Law::template Input<double>& input,
                                      const typename Law::template State<double>& state) {
  { law.stability_number(deformation, input, state) }
  noexcept->std::same_as<double>;
};

/// A law of grains that know the friction at which they yield, shear stress over pressure [-]: what a wall
/// bears that is as rough as the material.  Eq. (R164)
template <class Law>
concept HasYieldFriction = requires(const Law law) {
  { law.yield_friction() }
  noexcept->std::same_as<double>;
};

/// The same of one whose friction is by what it reads, and so by place.
template <class Law>
concept HasLocalYieldFriction = requires(const Law law, const typename Law::template Input<double>& input) {
  { law.yield_friction(input) }
  noexcept->std::same_as<double>;
};

}  // namespace scree::rheology
