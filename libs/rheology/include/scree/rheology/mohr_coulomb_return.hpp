#pragma once

#include <scree/tensor.hpp>

#include <array>
#include <cmath>

namespace scree::rheology {

/// Principal values, in descending order: tension first.
template <class Real>
using Principal = std::array<Real, 3>;

/// Elasticity, strength and flow of a Mohr-Coulomb material, as its return needs them.
struct MohrCoulombFlow {
  double sin_friction;   ///< sine of the friction angle, at least 0 and below 1
  double sin_dilatancy;  ///< sine of the dilatancy angle, likewise
  double shear_modulus;  ///< G [Pa]
  double lame_modulus;   ///< K - 2G/3 [Pa]
};

namespace detail {

template <class Condition, class Real>
[[nodiscard]] Principal<Real> select_each(const Condition& condition, const Principal<Real>& a,
                                          const Principal<Real>& b) noexcept {
  return {select(condition, a[0], b[0]), select(condition, a[1], b[1]), select(condition, a[2], b[2])};
}

/// The trial stress returned to the face sigma_1 > sigma_2 > sigma_3 of the pyramid or, where that would
/// change the order of the stresses, to the edge where two of them are equal; no thought of the apex.
/// An edge is a face for the mean of its two stresses.  Eqs. (R52) to (R54)
/// @param trial outside the pyramid  @param limit 2 c cos(phi) [Pa]
template <class Real>
[[nodiscard]] Principal<Real> returned_to_pyramid(const Principal<Real>& trial, const MohrCoulombFlow& flow,
                                                  const Real& limit) noexcept {
  const double n_1 = 1 + flow.sin_friction;
  const double n_3 = 1 - flow.sin_friction;
  const double spherical = 2 * flow.lame_modulus * flow.sin_dilatancy;
  const double m_1 = 2 * flow.shear_modulus * (1 + flow.sin_dilatancy) + spherical;  // stress per flow
  const double m_2 = spherical;
  const double m_3 = -2 * flow.shear_modulus * (1 - flow.sin_dilatancy) + spherical;

  const Real on_face = (n_1 * trial[0] - n_3 * trial[2] - limit) * (1 / (n_1 * m_1 - n_3 * m_3));
  const Principal<Real> face{trial[0] - m_1 * on_face, trial[1] - m_2 * on_face, trial[2] - m_3 * on_face};

  const double m_12 = 0.5 * (m_1 + m_2);
  const Real mean_12 = 0.5 * (trial[0] + trial[1]);
  const Real on_12 = (n_1 * mean_12 - n_3 * trial[2] - limit) * (1 / (n_1 * m_12 - n_3 * m_3));
  const Real equal_12 = mean_12 - m_12 * on_12;
  const Principal<Real> edge_12{equal_12, equal_12, trial[2] - m_3 * on_12};

  const double m_23 = 0.5 * (m_2 + m_3);
  const Real mean_23 = 0.5 * (trial[1] + trial[2]);
  const Real on_23 = (n_1 * trial[0] - n_3 * mean_23 - limit) * (1 / (n_1 * m_1 - n_3 * m_23));
  const Real equal_23 = mean_23 - m_23 * on_23;
  const Principal<Real> edge_23{trial[0] - m_1 * on_23, equal_23, equal_23};

  return select_each(face[0] < face[1], edge_12, select_each(face[1] < face[2], edge_23, face));
}

/// The trial stress returned to the planes sigma_i = tension as if there were no other: to one of them, two
/// or all three.  Eq. (R55)
/// @param rounding of stresses; within it all three are chosen [Pa]
template <class Real>
[[nodiscard]] Principal<Real> returned_to_tension(const Principal<Real>& trial, const MohrCoulombFlow& flow,
                                                  const Real& tension, double rounding) noexcept {
  const double along_one = flow.lame_modulus / (flow.lame_modulus + 2 * flow.shear_modulus);
  const double along_two = flow.lame_modulus / (2 * (flow.lame_modulus + flow.shear_modulus));
  const Real cut_one = along_one * (trial[0] - tension);
  const Principal<Real> one{tension, trial[1] - cut_one, trial[2] - cut_one};
  const Real third = trial[2] - along_two * (trial[0] + trial[1] - 2.0 * tension);
  const Principal<Real> two{tension, tension, third};
  const Principal<Real> three{tension, tension, tension};
  return select_each(one[1] <= tension, one, select_each(third < tension - rounding, two, three));
}

}  // namespace detail

/// Stress at the end of a step of a Mohr-Coulomb material that bears no principal stress above a tension:
/// the trial stress itself if it is within, else where Koiter's flow rule leads from it, in closed form. Each
/// region of the surface (face, two edges, apex, the planes of tension and the lines and points where they
/// meet the pyramid) is computed and one of them chosen, so that packs run it.
/// @see Eqs. (R51) to (R56), after Clausen et al. (2007), \cite clausen2007
/// @param trial elastic, in descending order [Pa]
/// @param limit 2 c cos(phi) [Pa]  @param tension not above the apex [Pa]
/// @param rounding of stresses [Pa]: a trial stress so close to bearing tension in all directions does so
template <class Real>
[[nodiscard]] Principal<Real> mohr_coulomb_return(const Principal<Real>& trial, const MohrCoulombFlow& flow,
                                                  const Real& limit, const Real& tension,
                                                  double rounding) noexcept {
  const double n_1 = 1 + flow.sin_friction;
  const double n_3 = 1 - flow.sin_friction;
  const Principal<Real> sheared = detail::select_each(limit < n_1 * trial[0] - n_3 * trial[2],
                                                      detail::returned_to_pyramid(trial, flow, limit), trial);
  const Principal<Real> torn = detail::returned_to_tension(trial, flow, tension, rounding);
  // Where the plane of tension meets the pyramid: neither flow strains along the second axis.
  const Real least = (n_1 * tension - limit) * (1 / n_3);
  const double poisson = flow.lame_modulus / (2 * (flow.lame_modulus + flow.shear_modulus));
  const Real between = trial[1] - poisson * (trial[0] - tension + trial[2] - least);
  const Real second = select(between < least, least, select(tension < between, tension, between));
  const Principal<Real> both{tension, second, least};
  return detail::select_each(tension < sheared[0], detail::select_each(torn[2] < least, both, torn), sheared);
}

}  // namespace scree::rheology
