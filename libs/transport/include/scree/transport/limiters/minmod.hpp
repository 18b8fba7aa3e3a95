#pragma once

#include <scree/error.hpp>
#include <scree/parameter.hpp>
#include <scree/transport/concepts.hpp>

#include <algorithm>

namespace scree::transport {

/// Generalised minmod limiter: the gentlest of three slopes, zero at an extremum.
///
/// theta = 1 is minmod (most diffusive), theta = 2 monotonised central (MC).
/// Takes and returns differences of one quantity over one cell, in its unit.
/// @see Eq. (T5a), \cite kurganov2000
class Minmod {
 public:
  static constexpr std::string_view name = "minmod";
  static constexpr std::string_view summary =
      "generalised minmod, theta from 1 (most diffusive) to 2 (monotonised central)";
  static constexpr std::array<Parameter, 1> parameters{{{"theta", "-", "sharpness of minmod, 1 to 2", 1}}};

  /// @param theta sharpness, 1 to 2 [-].  @throws InputError outside that range (or NaN).
  explicit Minmod(double theta = 1) : theta_{theta} {
    require(1 <= theta && theta <= 2, "Minmod: theta must lie in [1, 2]");
  }

  [[nodiscard]] double operator()(double backward, double forward) const noexcept {
    const double lowest = std::min(0.0, theta_ * std::max(backward, forward));
    const double highest = std::max(0.0, theta_ * std::min(backward, forward));
    // In this order a slope beside a value that is no number is one: what is wrong stays where it is.
    return std::min(highest, std::max(lowest, (backward + forward) / 2));
  }

  [[nodiscard]] double sharpness() const noexcept { return theta_; }

 private:
  double theta_;
};
static_assert(Limiter<Minmod>);

}  // namespace scree::transport
