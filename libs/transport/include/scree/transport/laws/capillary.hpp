#pragma once

#include <scree/error.hpp>
#include <scree/transport/components.hpp>
#include <scree/transport/concepts.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace scree::transport {

/// A fractional flow that capillary forces spread: adds the diffusivity 4 epsilon u (1 - u) to a scalar law,
/// as the potential K(u) = epsilon (2 u^2 - 4 u^3/3). None at 0 and 1, where fronts stay sharp.
/// @see Eq. (T20), \cite kurganov2000
template <class Law>
class Capillary : public Law {
 public:
  static_assert(Law::num_components == 1);
  using State = typename Law::State;

  /// @param epsilon largest diffusivity [m^2/s], zero or positive.  @throws InputError
  explicit Capillary(const Law& law = Law{}, double epsilon = 0.01) : Law{law}, epsilon_{epsilon} {
    require(epsilon >= 0 && std::isfinite(epsilon),
            "Capillary: the diffusivity must be zero or positive, and finite");
  }

  [[nodiscard]] State potential(const State& u) const noexcept {
    return {epsilon_ * u[0] * u[0] * (2 - 4.0 / 3 * u[0])};
  }

  /// At the point of the interval that is nearest to 1/2.
  [[nodiscard]] double max_diffusivity(const State& left, const State& right) const noexcept {
    const double widest = std::min(std::max(0.5, std::min(left[0], right[0])), std::max(left[0], right[0]));
    return larger(4 * epsilon_ * widest * (1 - widest), 0 * (left[0] + right[0]));
  }

 private:
  double epsilon_;
};

}  // namespace scree::transport
