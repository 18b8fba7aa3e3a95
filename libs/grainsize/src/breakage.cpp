#include "checks.hpp"

#include <scree/grainsize/breakage.hpp>
#include <scree/grainsize/distribution.hpp>

#include <cmath>
#include <cstddef>

namespace scree::grainsize {

namespace {

/// Volume of fragments between two sizes, up to a factor.  Eq. (G16) with n = 0
double volume_between(double from, double to, double fractal_dimension) noexcept {
  const double p = 3 - fractal_dimension;
  const double log_ratio = std::log(to / from);
  return p == 0 ? log_ratio : std::pow(from, p) * std::expm1(p * log_ratio) / p;
}

/// @throws InputError at the first edge below which there is more volume at first than in the end.
void require_coarser(const SizeClasses& classes, std::span<const double> initial,
                     std::span<const double> ultimate) {
  double finer = 0;
  double finer_in_the_end = 0;
  for (std::size_t k = 0; k < classes.size(); ++k) {
    finer += initial[k];
    finer_in_the_end += ultimate[k];
    const double rounding = 8 * round_off * static_cast<double>(classes.size());  // of two sums
    if (finer <= finer_in_the_end + rounding) continue;
    throw InputError{detail::message("ultimate_fractions: a share of ", finer, " is finer than ",
                                     classes.edges()[k + 1], " m at first, but only ", finer_in_the_end,
                                     " in the end: breaking would join grains")};
  }
}

}  // namespace

std::vector<double> ultimate_fractions(const SizeClasses& classes, std::span<const double> initial,
                                       double fractal_dimension) {
  constexpr double typed = 1e-9;  // what may be lost in typing fractions
  require_fractions(classes, initial, typed);
  require(!classes.edges().empty(), "ultimate_fractions: the size classes must have edges");
  require(std::isfinite(fractal_dimension), "ultimate_fractions: the fractal dimension must be finite");
  std::size_t num_present = classes.size();
  while (initial[num_present - 1] <= 0) --num_present;
  const auto edges = classes.edges();
  std::vector<double> ultimate(classes.size());
  const double whole = volume_between(edges[0], edges[num_present], fractal_dimension);
  for (std::size_t k = 0; k < num_present; ++k) {
    ultimate[k] = volume_between(edges[k], edges[k + 1], fractal_dimension) / whole;
  }
  require_coarser(classes, initial, ultimate);
  return ultimate;
}

void break_grains(std::span<double> fractions, std::span<const double> ultimate, double share) noexcept {
  SCREE_ASSERT(fractions.size() == ultimate.size() && 0 <= share && share <= 1);
  for (std::size_t k = 0; k < fractions.size(); ++k) {
    fractions[k] = broken_fraction(fractions[k], ultimate[k], share);
  }
}

double grading_index(std::span<const double> diameters, std::span<const double> initial,
                     std::span<const double> ultimate) noexcept {
  return 1 - moment(diameters, ultimate, 2) / moment(diameters, initial, 2);
}

}  // namespace scree::grainsize
