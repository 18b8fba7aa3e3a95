#pragma once

#include <scree/grainsize/size_classes.hpp>

#include <span>
#include <vector>

namespace scree::grainsize {

/// The distribution that crushing tends to: fragments of which the number coarser than s falls as
/// s^-fractal_dimension, by volume, from the lower edge of the finest class to the upper edge of the coarsest
/// that is present at first. Crushing makes no grain larger.  Eq. (G20), from Einav (2007), \cite einav2007
/// @param initial fractions at first [-], one per class  @param fractal_dimension 2.5 to 2.7 in crushed rock
/// [-]
/// @return fractions [-], one per class, their sum 1 to round-off
/// @throws InputError if the classes have no edges, the fractions do not fit them, the dimension is not
/// finite, or some share finer than an edge is larger at first than in the end: then breaking would join
/// grains.
[[nodiscard]] std::vector<double> ultimate_fractions(const SizeClasses& classes,
                                                     std::span<const double> initial,
                                                     double fractal_dimension = 2.6);

/// Which share of the way that is left to the ultimate distribution a change of the breakage B goes [-], in
/// [0, 1]; none where B does not grow.  Eq. (G21)
/// @param before, after B [-], in [0, 1]
[[nodiscard]] constexpr double broken_share(double before, double after) noexcept {
  return after > before ? (after - before) / (1 - before) : 0;
}

/// A fraction that goes `share` of the way to its ultimate value [-].  Eq. (G21)
[[nodiscard]] constexpr double broken_fraction(double fraction, double ultimate, double share) noexcept {
  return (1 - share) * fraction + share * ultimate;
}

/// Moves volume from class to class as grains break: the fractions go `share` of the way to the ultimate
/// ones. A convex combination: the sum stays and every fraction lies between what it was and its ultimate
/// value, up to round-off. Steps may be split at will.  Eq. (G21)
/// @param fractions Phi_k [-]  @param ultimate [-], as many  @param share in [0, 1], of `broken_share`
void break_grains(std::span<double> fractions, std::span<const double> ultimate, double share) noexcept;

/// theta [-], the share of the elastic energy of grains that would be free if all broke to the ultimate
/// distribution: 1 less the ratio of the mean square sizes, for at a given stress a grain's energy per volume
/// goes with the square of its size.  Eq. (G22), from Einav (2007), \cite einav2007
[[nodiscard]] double grading_index(std::span<const double> diameters, std::span<const double> initial,
                                   std::span<const double> ultimate) noexcept;

}  // namespace scree::grainsize
