#pragma once

#include <scree/tensor.hpp>

#include <cmath>

namespace scree::rheology::elementary {

/// The elementary functions of one kind of number. A number that has none of its own, like a pack of doubles,
/// may be given better ones by specialising this; else it is asked for its own, lane by lane in a pack.
template <class Real>
struct Functions {
  [[nodiscard]] static Real exp(const Real& x) noexcept {
    using std::exp;
    return exp(x);
  }
  [[nodiscard]] static Real expm1(const Real& x) noexcept {
    using std::expm1;
    return expm1(x);
  }
  [[nodiscard]] static Real log(const Real& x) noexcept {
    using std::log;
    return log(x);
  }
  [[nodiscard]] static Real pow(const Real& base, const Real& exponent) noexcept {
    using std::pow;
    return pow(base, exponent);
  }
};

// What laws call, with the name of this namespace, so that a number's own function is not found instead.

/// e^x [-].
template <class Real>
[[nodiscard]] Real exp(const Real& x) noexcept {
  return Functions<Real>::exp(x);
}

/// e^x - 1 [-], precise for small x too.
template <class Real>
[[nodiscard]] Real expm1(const Real& x) noexcept {
  return Functions<Real>::expm1(x);
}

/// The natural logarithm [-]; -infinity of zero, NaN of less.
template <class Real>
[[nodiscard]] Real log(const Real& x) noexcept {
  return Functions<Real>::log(x);
}

/// The natural logarithm [-] of what is near one as a rule, like a ratio of densities: precise there, by
/// powers of (x - 1)/(x + 1), and quick; the common one elsewhere, for each lane by its own number alone.
template <class Real>
[[nodiscard]] Real log_near_one(const Real& x) noexcept {
  constexpr double reach = 1.0 / 40;  // the next power is less than 1e-17 of the sum
  const Real z = (x - 1.0) / (x + 1.0);
  const Real square = z * z;
  const Real fourth = square * square;
  const Real first = 2.0 + 2.0 / 3 * square;
  const Real second = 2.0 / 5 + 2.0 / 7 * square;
  Real result = z * (first + fourth * (second + 2.0 / 9 * fourth));
  const auto is_far = !(square <= reach * reach);
  if (in_any_lane(is_far)) [[unlikely]] {
    result = select(is_far, log(x), result);
  }
  return result;
}

/// base^exponent [-].
template <class Real>
[[nodiscard]] Real pow(const Real& base, const Real& exponent) noexcept {
  return Functions<Real>::pow(base, exponent);
}

}  // namespace scree::rheology::elementary
