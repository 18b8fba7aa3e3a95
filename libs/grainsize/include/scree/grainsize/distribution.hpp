#pragma once

#include <scree/grainsize/size_classes.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace scree::grainsize {

/// How the solid volume of a mixture is shared among size classes.
struct Distribution {
  SizeClasses classes;
  std::vector<double> fractions;  ///< Phi_k [-], one per class, each in [0, 1], their sum 1 to round-off
};

/// Arithmetic mean size s_a = sum Phi_k s_k [m].  Eq. (G1)
/// @param diameters s_k [m]  @param fractions Phi_k [-], as many
[[nodiscard]] double arithmetic_mean(std::span<const double> diameters,
                                     std::span<const double> fractions) noexcept;

/// Harmonic mean size s_h = sum Phi_k / sum(Phi_k / s_k) [m]: the one for which the exchange of grains moves
/// no bulk. The numerator keeps round-off in the sum from growing.  Eq. (G2)
/// @param diameters s_k [m]  @param fractions Phi_k [-], as many, not all zero
[[nodiscard]] double harmonic_mean(std::span<const double> diameters,
                                   std::span<const double> fractions) noexcept;

/// Moment sum Phi_k s_k^order [m^order]; order 1 is the arithmetic mean.  Eq. (G13)
[[nodiscard]] double moment(std::span<const double> diameters, std::span<const double> fractions,
                            double order) noexcept;

/// The size [m] below which `share` of the solid volume lies: 0.5 gives the median d_50.  Eq. (G14)
///
/// Volume is spread evenly between the edges of a class; a class without edges holds it all at s_k.
/// @param share in [0, 1] [-]  @throws InputError outside, or if the fractions do not fit the classes.
[[nodiscard]] double percentile(const SizeClasses& classes, std::span<const double> fractions, double share);

/// Share of the volume of each class whose grains are as large as `size` or larger [-], one per class: with
/// it, sum Phi_k share_k is the share of a mixture. Volume is spread as for a percentile.  Eq. (G23)
/// @param size [m], positive and finite  @throws InputError if it is not.
[[nodiscard]] std::vector<double> coarse_shares(const SizeClasses& classes, double size);

/// Checks that `fractions` are one per class, each in [0, 1], with the sum 1, within `tolerance`.
/// @throws InputError naming the first fault.
void require_fractions(const SizeClasses& classes, std::span<const double> fractions, double tolerance);

/// A measured histogram. The volume of a class is spread evenly between its edges, so that s_k is their
/// middle and the arithmetic mean of the histogram is kept.
/// @param edges [m], positive, strictly increasing, one more than fractions
/// @param fractions shares of the solid volume [-]. They may miss the sum 1 by what is lost in typing nine
///   digits, and are then divided by their sum.
/// @throws InputError if either is not as said.
[[nodiscard]] Distribution histogram(std::vector<double> edges, std::vector<double> fractions);

/// Grains of one size [m].  @throws InputError unless it is positive and finite.
[[nodiscard]] Distribution monodisperse(double diameter);

/// Grains of two sizes [m].
/// @param fraction_small share of the finer ones [-], in [0, 1]
/// @throws InputError for bad sizes or a share outside [0, 1].
[[nodiscard]] Distribution bidisperse(double diameter_small, double diameter_large, double fraction_small);

/// Equal shares of `num_classes` sizes, equally spaced from `diameter_min` to `diameter_max` [m].
/// @throws InputError unless 0 < diameter_min < diameter_max and there are two classes or more.
[[nodiscard]] Distribution polydisperse(double diameter_min, double diameter_max, std::size_t num_classes);

/// Solid volume by size as a normal distribution of ln s, cut at both ends.  Eq. (G15)
struct LogNormal {
  double median;        ///< of the uncut distribution [m]
  double spread;        ///< standard deviation of ln s [-]
  double diameter_min;  ///< lower cut [m]
  double diameter_max;  ///< upper cut [m]
};

/// Fragments of which the number coarser than s falls as s^-fractal_dimension, cut at both ends.  Eq. (G16)
struct PowerLaw {
  double fractal_dimension;  ///< 2.5 to 2.7 in crushed rock [-]
  double diameter_min;       ///< lower cut [m]
  double diameter_max;       ///< upper cut [m]
};

/// Exact moment of the cut distribution by volume [m^order].  Eq. (G15), (G16)
/// @throws InputError for parameters that describe no distribution.
[[nodiscard]] double moment(const LogNormal& law, double order);
[[nodiscard]] double moment(const PowerLaw& law, double order);

/// Bins a distribution into classes of equal ratio of edges, by its exact CDF. Each s_k is the mean size of
/// the volume in its class: the arithmetic mean of the whole is exact for any number of classes, other
/// moments converge with its square.  Eq. (G17)
/// @throws InputError for bad parameters, no class, or a class so far from the median that it is empty.
[[nodiscard]] Distribution binned(const LogNormal& law, std::size_t num_classes);
[[nodiscard]] Distribution binned(const PowerLaw& law, std::size_t num_classes);

}  // namespace scree::grainsize
