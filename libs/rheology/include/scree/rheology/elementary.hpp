#pragma once

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

/// base^exponent [-].
template <class Real>
[[nodiscard]] Real pow(const Real& base, const Real& exponent) noexcept {
  return Functions<Real>::pow(base, exponent);
}

}  // namespace scree::rheology::elementary
