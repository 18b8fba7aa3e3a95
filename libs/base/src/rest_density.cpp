#include <scree/rest_density.hpp>
#include <scree/tensor.hpp>

#include <cmath>
#include <utility>

namespace scree {

namespace {

constexpr double first_share =
    1e-3;  // by which the second try is denser: linear laws are all but linear there

[[nodiscard]] std::optional<double> by_secants(const std::function<double(double)>& excess, double start) {
  constexpr int max_iterations = 100;
  double previous = start;
  double density = start * (1 + first_share);
  double at_previous = excess(previous);
  double at_density = excess(density);
  if (at_density == at_previous) return std::nullopt;
  if (at_previous == 0) {  // it touches there, or only further on
    const bool touches = excess(start * (1 + 4 * round_off)) > 0;
    return touches ? std::optional{start} : std::nullopt;
  }
  for (int i = 0; i < max_iterations; ++i) {
    if (at_density == 0 || std::abs(density - previous) <= 4 * round_off * density) return density;
    const double next = density - at_density * (density - previous) / (at_density - at_previous);
    if (!(next > 0 && std::isfinite(next))) break;
    previous = std::exchange(density, next);
    at_previous = std::exchange(at_density, excess(density));
  }
  return std::nullopt;
}

[[nodiscard]] std::optional<double> by_bisection(const std::function<double(double)>& excess, double start) {
  constexpr double widest = 3;  // share of the start
  const bool is_too_thin = !(excess(start) > 0);
  double thin = start;
  double dense = start;
  for (double share = first_share;; share *= 2) {
    if (share > widest) return std::nullopt;
    (is_too_thin ? dense : thin) = is_too_thin ? start * (1 + share) : start / (1 + share);
    if (is_too_thin ? excess(dense) > 0 : excess(thin) <= 0) break;
    (is_too_thin ? thin : dense) = is_too_thin ? dense : thin;
  }
  for (double middle = (thin + dense) / 2; thin < middle && middle < dense; middle = (thin + dense) / 2) {
    (excess(middle) > 0 ? dense : thin) = middle;
  }
  return thin;
}

}  // namespace

std::optional<double> rest_density(const std::function<double(double)>& excess, double start) {
  const std::optional<double> density = by_secants(excess, start);
  return density ? density : by_bisection(excess, start);
}

}  // namespace scree
