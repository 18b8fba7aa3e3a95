#pragma once

#include <scree/tensor.hpp>
#include <scree/transport/components.hpp>
#include <scree/transport/concepts.hpp>
#include <scree/transport/face.hpp>

#include <array>
#include <cmath>
#include <cstddef>

namespace scree::grainsize {

/// Segregation and remixing of N size classes at a point, with a given driver: F_k = Phi_k B (1 - s_h/s_k),
/// to which the scheme adds -D grad Phi_k. The fluxes of all classes add to zero.
/// @see Eqs. (G3), (G5)
template <int N>
struct PointSegregation {
  static constexpr int num_components = N;
  using State = std::array<double, static_cast<std::size_t>(N)>;  ///< fractions Phi_k [-]

  const State* inverse_sizes;  ///< 1/s_k [1/m], decreasing; not owned
  double driver;               ///< B along the normal [m/s]
  double remixing;             ///< D [m^2/s]

  /// F_k along the normal [m/s]. Written with s_h = S/H so that a pure state has no flux at all.  Eq. (G3)
  template <int D>
  [[nodiscard]] State flux(const State& phi, const Vector<D>& /*normal*/) const noexcept {
    const Sums sums = sums_of(phi);
    const double factor = driver * (1 / sums.volume_per_size);  // one division for flux and speed
    State result;
    transport::for_each_component<N>([&](std::size_t k) {
      result[k] = factor * (phi[k] * (sums.volume_per_size - sums.volume * (*inverse_sizes)[k]));
    });
    return result;
  }

  /// Bound of every characteristic speed and of every class's velocity, at all states between two [m/s]. It
  /// is taken from all N classes, whether present or not.  Eq. (G10)
  template <int D>
  [[nodiscard]] double max_speed(const State& left, const State& right,
                                 const Vector<D>& /*normal*/) const noexcept {
    return std::abs(driver) * transport::larger(relative_speed(left), relative_speed(right));
  }

  /// D Phi_k [m^2/s].
  [[nodiscard]] State potential(const State& phi) const noexcept {
    State result;
    transport::for_each_component<N>([&](std::size_t k) { result[k] = remixing * phi[k]; });
    return result;
  }

  /// D [m^2/s].
  [[nodiscard]] double max_diffusivity(const State& /*left*/, const State& /*right*/) const noexcept {
    return remixing;
  }

 private:
  struct Sums {
    double volume = 0;           ///< S = sum Phi_k [-]
    double volume_per_size = 0;  ///< H = sum Phi_k/s_k [1/m]; s_h = S/H.  Eq. (G2)
  };

  [[nodiscard]] Sums sums_of(const State& phi) const noexcept {
    Sums sums;
    transport::for_each_component<N>([&](std::size_t k) {
      sums.volume += phi[k];
      sums.volume_per_size += phi[k] * (*inverse_sizes)[k];
    });
    return sums;
  }

  /// The bound over |B| at one state.
  [[nodiscard]] double relative_speed(const State& phi) const noexcept {
    const Sums sums = sums_of(phi);
    const double s_h = sums.volume * (1 / sums.volume_per_size);
    return transport::larger(s_h * inverse_sizes->front() - 1, 1 - s_h * inverse_sizes->back());
  }
};

/// Segregation on a lattice: the driver differs from face to face.
///
/// The number of classes is that of the loops, N; mixtures with fewer are filled up with classes of the
/// largest size and no volume, which change nothing.
template <int N>
struct SegregationLaw {
  std::array<double, static_cast<std::size_t>(N)> inverse_sizes;  ///< 1/s_k [1/m], decreasing
  double remixing;                                                ///< D [m^2/s]
  /// B along +axis at the face above each site [m/s]: one row of num_sites per axis; not owned
  const double* drivers;
  Index num_sites;
  /// What the face above each site along axis 0 is stretched by round an axis of symmetry [-], in the drivers
  /// already; none elsewhere; not owned.  Eq. (M181)
  const double* stretches = nullptr;

  [[nodiscard]] PointSegregation<N> at(const transport::Face& face) const noexcept {
    const double stretch = stretches != nullptr && face.axis == 0 ? stretches[face.owner] : 1;
    return {&inverse_sizes, drivers[face.axis * num_sites + face.owner], stretch * remixing};
  }
};
static_assert(transport::ConservationLaw<SegregationLaw<2>, 1>);

}  // namespace scree::grainsize
