#pragma once

#include <scree/rheology/slope.hpp>
#include <scree/tensor.hpp>

#include <cmath>

namespace scree::rheology {

/// Elastic strains of a crushable material in units of those at which it breaks, and its breakage: x of the
/// volume, z of the shape, so that E_B/E_c = x^2 + z^2 and q/(M p) = m z/x.  Eq. (R113)
template <class Real>
struct BreakageState {
  Real volume;         ///< x [-], compression positive
  Real shape;          ///< z [-], not negative
  Real breakage;       ///< B [-], 0 to 1
  Real unsolved{0.0};  ///< of the step's equation, `Response::unsolved` [-]
};

/// The flow of Einav (2007) over a step, backward in time: from a trial state outside the yield surface to
/// that at the end of the step.
///
/// What is left of four equations is one for u = q/(M p) / (m (1-B) x), from 0 (compressed alike from all
/// sides) to infinity (friction alone). Newton's method, from the point of the surface at the trial's own
/// volume, took 11 steps at most for any trial that was tried; a fixed number, for packs.
/// @see Eqs. (R113) to (R116)
struct BreakageReturn {
  double grading;         ///< theta [-], in (0, 1)
  double cosine;          ///< of the coupling angle omega, squared [-]
  double friction_ratio;  ///< m = sqrt(3 G/K)/M [-]

  /// y of a state: it flows if this is positive.  Eq. (R113)
  template <class Real>
  [[nodiscard]] Real yield(const BreakageState<Real>& at) const noexcept {
    const Real rest = 1.0 - at.breakage;
    const Real mobilised = friction_ratio * at.shape / at.volume;
    return rest * rest * (at.volume * at.volume + at.shape * at.shape) + mobilised * mobilised - 1.0;
  }

  /// @param trial outside the surface, under pressure
  template <class Real>
  [[nodiscard]] BreakageState<Real> operator()(const BreakageState<Real>& trial) const noexcept {
    using std::sqrt;
    constexpr int num_iterations = 14;
    constexpr double tolerance = 1e-12;  // relative; an iteration more would square it
    const Real rest = 1.0 - trial.breakage;
    const Real reach = rest * trial.volume;
    const Real widest = select(reach < 1.0, 1.0 - reach * reach, Real(0.0));
    const double m_2 = friction_ratio * friction_ratio;
    Real u = sqrt(widest / (reach * reach + m_2)) / reach;
    for (int i = 0; i < num_iterations; ++i) {
      const Slope<Real> left = flow_at(Slope<Real>{u, Real(1.0)}, trial).left;
      u = u - left.value / left.slope;
    }
    const Flow<Real> end = flow_at(Slope<Real>{u, Real(1.0)}, trial);
    const Real w = select(end.progress < 0.0, Real(0.0), end.progress);
    const Real gain = 2.0 * w * (1 / grading - trial.breakage) / (1.0 + 2.0 * w);
    const Real rest_after = (rest - (2 * (1 - grading) / grading) * w) / (1.0 + 2.0 * w);
    const Real correction = end.left.value / (end.left.slope * u);  // of u, had the iteration gone on
    const Real error =
        select(end.left.value == 0.0, Real(0.0), select(correction < 0.0, -correction, correction));
    return {end.xi / rest_after, end.rho * end.xi / rest_after, trial.breakage + gain,
            select(error <= tolerance, Real(0.0), error)};
  }

 private:
  /// The step's equation at a trial u, and what follows from u.
  template <class Real>
  struct Flow {
    Slope<Real> left;  ///< zero at the solution  Eq. (R116)
    Real progress;     ///< w = theta/2 (B - B_0)/(1 - theta B)
    Real xi;           ///< (1 - B) x
    Real rho;          ///< z/x
  };

  template <class Real>
  [[nodiscard]] Flow<Real> flow_at(const Slope<Real>& u, const BreakageState<Real>& trial) const noexcept {
    const double m_2 = friction_ratio * friction_ratio;
    const double tangent = 1 / cosine - 1;  // of omega, squared
    const Real steepness = trial.shape / trial.volume;
    const Slope<Real> a = Real(1.0) + Real(m_2) * (u * u);
    const Slope<Real> xi_2 = Slope<Real>{Real(2.0)} / (a + sqrt(a * a + Real(4.0) * (u * u)));
    const Slope<Real> xi = sqrt(xi_2);
    const Slope<Real> rho = u * xi;
    const Slope<Real> tau = Real(tangent) * (Real(1.0) + rho * rho);
    const Slope<Real> stretch = Slope<Real>{trial.volume} / xi;
    const Slope<Real> beyond = Real(-1.0) + (1.0 - trial.breakage) * stretch;
    const Slope<Real> half = Real(2.0) + tau + Real(2 * (1 - grading) / grading) * stretch;
    const Slope<Real> w = Real(2.0) * beyond / (half + sqrt(half * half + Real(8.0) * (tau * beyond)));
    const Slope<Real> slowing = Real(1.0) + Real(m_2 / cosine) * (w / xi_2);
    const Slope<Real> left = xi * (rho * slowing - steepness * (Real(1.0) + w * tau));
    return {left, w.value, xi.value, rho.value};
  }
};

}  // namespace scree::rheology
