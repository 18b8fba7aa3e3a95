#include "checks.hpp"

#include <scree/grainsize/distribution.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <string_view>
#include <utility>

namespace scree::grainsize {

namespace {

/// What may be lost in typing fractions with nine digits [-].
constexpr double typed_sum_tolerance = 1e-9;

double sum(std::span<const double> values) noexcept {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

void divide_by_sum(std::vector<double>& values) {
  const double total = sum(values);
  for (double& value : values) value /= total;
}

/// Share of a standard normal distribution between a < b; differences of the nearer tail, so that it keeps
/// its digits far from the middle.
double normal_share(double a, double b) noexcept {
  if (a > 0) return normal_share(-b, -a);
  const double scale = 1 / std::numbers::sqrt2;
  return (std::erfc(-b * scale) - std::erfc(-a * scale)) / 2;
}

void require_cuts(std::string_view name, double diameter_min, double diameter_max) {
  if (!(0 < diameter_min && diameter_min < diameter_max && std::isfinite(diameter_max))) {
    throw InputError{detail::message(name, ": the cuts are ", diameter_min, " m and ", diameter_max,
                                     " m, but must satisfy 0 < diameter_min < diameter_max")};
  }
}

void require_valid(const LogNormal& law) {
  require_cuts("LogNormal", law.diameter_min, law.diameter_max);
  require(law.median > 0 && std::isfinite(law.median), "LogNormal: the median must be positive and finite");
  require(law.spread > 0 && std::isfinite(law.spread), "LogNormal: the spread must be positive and finite");
}

void require_valid(const PowerLaw& law) {
  require_cuts("PowerLaw", law.diameter_min, law.diameter_max);
  require(std::isfinite(law.fractal_dimension), "PowerLaw: the fractal dimension must be finite");
}

/// Integral of s^order over the uncut distribution's volume between two sizes [m^order].  Eq. (G15)
double partial_moment(const LogNormal& law, double order, double from, double to) {
  const double variance = law.spread * law.spread;
  const double shift = std::log(law.median) + order * variance;
  return std::pow(law.median, order) * std::exp(order * order * variance / 2) *
         normal_share((std::log(from) - shift) / law.spread, (std::log(to) - shift) / law.spread);
}

/// The same of the density s^(2 - fractal_dimension), not normalised.  Eq. (G16)
double partial_moment(const PowerLaw& law, double order, double from, double to) {
  const double exponent = 3 - law.fractal_dimension + order;
  const double log_ratio = std::log(to / from);
  if (exponent == 0) return log_ratio;
  return std::pow(from, exponent) * std::expm1(exponent * log_ratio) / exponent;
}

template <class Law>
double exact_moment(const Law& law, double order) {
  require_valid(law);
  return partial_moment(law, order, law.diameter_min, law.diameter_max) /
         partial_moment(law, 0, law.diameter_min, law.diameter_max);
}

/// num_classes + 1 lengths of equal ratio from first to last [m].
std::vector<double> equal_ratios(double first, double last, std::size_t num_classes) {
  std::vector<double> edges(num_classes + 1, first);
  for (std::size_t k = 1; k < num_classes; ++k) {
    edges[k] = first * std::pow(last / first, static_cast<double>(k) / static_cast<double>(num_classes));
  }
  edges.back() = last;
  return edges;
}

template <class Law>
Distribution bin(const Law& law, std::size_t num_classes) {
  require_valid(law);
  require(num_classes >= 1, "binned: there must be at least one class");
  std::vector<double> edges = equal_ratios(law.diameter_min, law.diameter_max, num_classes);
  std::vector<double> diameters(num_classes);
  std::vector<double> fractions(num_classes);
  for (std::size_t k = 0; k < num_classes; ++k) {
    fractions[k] = partial_moment(law, 0, edges[k], edges[k + 1]);
    if (!(fractions[k] > 0)) {
      throw InputError{detail::message("binned: no volume lies in class ", k + 1, ", from ", edges[k],
                                       " m to ", edges[k + 1], " m: bring the cuts nearer to the median")};
    }
    diameters[k] = partial_moment(law, 1, edges[k], edges[k + 1]) / fractions[k];
  }
  divide_by_sum(fractions);
  return {SizeClasses{std::move(diameters), std::move(edges)}, std::move(fractions)};
}

}  // namespace

double arithmetic_mean(std::span<const double> diameters, std::span<const double> fractions) noexcept {
  return std::inner_product(fractions.begin(), fractions.end(), diameters.begin(), 0.0);
}

double harmonic_mean(std::span<const double> diameters, std::span<const double> fractions) noexcept {
  const double per_size =
      std::inner_product(fractions.begin(), fractions.end(), diameters.begin(), 0.0, std::plus<>{},
                         [](double phi, double diameter) { return phi / diameter; });
  return sum(fractions) / per_size;
}

double moment(std::span<const double> diameters, std::span<const double> fractions, double order) noexcept {
  return std::inner_product(fractions.begin(), fractions.end(), diameters.begin(), 0.0, std::plus<>{},
                            [order](double phi, double diameter) { return phi * std::pow(diameter, order); });
}

double percentile(const SizeClasses& classes, std::span<const double> fractions, double share) {
  require_fractions(classes, fractions, typed_sum_tolerance);
  if (!(0 <= share && share <= 1)) {
    throw InputError{detail::message("percentile: the share is ", share, ", but must lie in [0, 1]")};
  }
  const double target = share * sum(fractions);
  double below = 0;
  double size = 0;
  for (std::size_t k = 0; k < classes.size(); ++k) {
    if (fractions[k] <= 0) continue;
    const double part = std::clamp((target - below) / fractions[k], 0.0, 1.0);
    size = classes.edges().empty() ? classes.diameters()[k]
                                   : std::lerp(classes.edges()[k], classes.edges()[k + 1], part);
    below += fractions[k];
    if (below >= target) break;
  }
  return size;
}

std::vector<double> coarse_shares(const SizeClasses& classes, double size) {
  if (!(0 < size && std::isfinite(size))) {
    throw InputError{
        detail::message("coarse_shares: the size is ", size, " m, but must be positive and finite")};
  }
  std::vector<double> shares;
  for (std::size_t k = 0; k < classes.size(); ++k) {
    if (classes.edges().empty()) {
      shares.push_back(classes.diameters()[k] >= size ? 1 : 0);
    } else {
      const double low = classes.edges()[k];
      const double high = classes.edges()[k + 1];
      shares.push_back(std::clamp((high - size) / (high - low), 0.0, 1.0));
    }
  }
  return shares;
}

void require_fractions(const SizeClasses& classes, std::span<const double> fractions, double tolerance) {
  if (fractions.size() != classes.size()) {
    throw InputError{detail::message("fractions: ", classes.size(), " classes need as many fractions, but ",
                                     fractions.size(), " are given")};
  }
  for (std::size_t k = 0; k < fractions.size(); ++k) {
    if (!(fractions[k] >= -tolerance && fractions[k] <= 1 + tolerance)) {
      throw InputError{
          detail::message("fractions: fraction ", k + 1, " is ", fractions[k], ", but must lie in [0, 1]")};
    }
  }
  if (!(std::abs(sum(fractions) - 1) <= tolerance)) {
    throw InputError{detail::message("fractions: their sum is ", sum(fractions), ", but must be 1")};
  }
}

Distribution histogram(std::vector<double> edges, std::vector<double> fractions) {
  if (edges.size() != fractions.size() + 1) {
    throw InputError{detail::message("histogram: ", fractions.size(), " fractions need ",
                                     fractions.size() + 1, " edges, but ", edges.size(), " are given")};
  }
  detail::require_increasing(edges, "histogram: edge");
  std::vector<double> diameters(fractions.size());
  for (std::size_t k = 0; k < diameters.size(); ++k) diameters[k] = std::midpoint(edges[k], edges[k + 1]);
  SizeClasses classes{std::move(diameters), std::move(edges)};
  require_fractions(classes, fractions, typed_sum_tolerance);
  divide_by_sum(fractions);
  return {std::move(classes), std::move(fractions)};
}

Distribution monodisperse(double diameter) {
  return {SizeClasses{{diameter}}, {1}};
}

Distribution bidisperse(double diameter_small, double diameter_large, double fraction_small) {
  Distribution result{SizeClasses{{diameter_small, diameter_large}}, {fraction_small, 1 - fraction_small}};
  require_fractions(result.classes, result.fractions, 0);
  return result;
}

Distribution polydisperse(double diameter_min, double diameter_max, std::size_t num_classes) {
  require_cuts("polydisperse", diameter_min, diameter_max);
  require(num_classes >= 2, "polydisperse: there must be at least two classes");
  std::vector<double> diameters(num_classes);
  for (std::size_t k = 0; k < num_classes; ++k) {
    diameters[k] =
        std::lerp(diameter_min, diameter_max, static_cast<double>(k) / static_cast<double>(num_classes - 1));
  }
  return {SizeClasses{std::move(diameters)},
          std::vector<double>(num_classes, 1 / static_cast<double>(num_classes))};
}

double moment(const LogNormal& law, double order) {
  return exact_moment(law, order);
}
double moment(const PowerLaw& law, double order) {
  return exact_moment(law, order);
}

Distribution binned(const LogNormal& law, std::size_t num_classes) {
  return bin(law, num_classes);
}
Distribution binned(const PowerLaw& law, std::size_t num_classes) {
  return bin(law, num_classes);
}

}  // namespace scree::grainsize
