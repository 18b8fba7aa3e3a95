#pragma once

#include <scree/blocks.hpp>
#include <scree/grainsize/closures.hpp>
#include <scree/grainsize/size_classes.hpp>
#include <scree/lattice.hpp>
#include <scree/symmetry.hpp>
#include <scree/transport/integrators.hpp>
#include <scree/transport/limiters.hpp>

#include <memory>
#include <optional>
#include <span>

namespace scree::grainsize {

/// How a mixture segregates, and by which scheme.
struct SegregationOptions {
  AnyClosure closure;               ///< what drives it
  double remixing = 0;              ///< D [m^2/s], at least 0.  Eq. (G5)
  transport::AnyLimiter limiter{};  ///< one factor for all classes of a site
  transport::AnyIntegrator integrator{};
  double cfl = 0.5;  ///< in (0, 1/2]: up to there every fraction keeps its bounds.  Eq. (G18)
  Symmetry symmetry = Symmetry::plane;  ///< what masses are those of.  Eqs. (M180), (M181)
};

/// What a call of Segregation::advance did.
struct SegregationReport {
  int substeps;  ///< steps it was cut into
  double
      max_speed;  ///< largest bound of a wave speed met, stretched round an axis [m/s].  Eqs. (G10), (M181)
  double stable_dt;  ///< the step that the bound allowed at the last substep [s]
};

/// Segregation and remixing on a lattice of control volumes, each with a mass of its own or empty.
///
/// Arrays have one entry per site of the lattice, first axis fastest; fractions are num_sites x num_classes,
/// class fastest. Work arrays are made once. The result has the same bits for any number of threads.
/// @see Eqs. (M1), (G3), (G5), (G18)
template <int D>
class Segregation {
 public:
  /// Most size classes that a mixture may have.
  static constexpr std::size_t max_num_classes = 16;

  /// @param gravity_direction unit vector, or zero where there is none
  /// @param lattice round an axis of symmetry: its low end along axis 0 is the axis
  /// @throws InputError for more than max_num_classes classes, remixing < 0, a CFL number outside (0, 1/2], a
  ///   direction that is neither zero nor of unit length, or none for a closure that acts along gravity,
  ///   an axis of symmetry where axis 0 is periodic.
  Segregation(const SizeClasses& classes, const SegregationOptions& options, const Lattice<D>& lattice,
              const Vector<D>& gravity_direction, Threads threads);
  ~Segregation();
  Segregation(Segregation&&) noexcept;
  Segregation& operator=(Segregation&&) noexcept;
  Segregation(const Segregation&) = delete;
  Segregation& operator=(const Segregation&) = delete;

  /// Lets the fractions exchange over `dt`, in as many steps as the stability limit asks for. Empty sites
  /// are left as they are.
  /// @param masses of the sites [kg], of a radian round an axis of symmetry; 0 for an empty one
  /// @param drive the closure's drive, averaged to the sites by mass; ignored where empty
  /// @param fractions Phi_k [-], updated; unchanged if this throws
  /// @param dt duration [s], at least 0
  /// @throws InputError if an array has the wrong length, a mass is negative or not finite, or dt is.
  /// @throws RunError if drive or fractions are not finite.
  SegregationReport advance(std::span<const double> masses, std::span<const double> drive,
                            std::span<double> fractions, double dt);

  /// The longest stable step of this state [s]; infinity if nothing moves. Arguments and exceptions as above.
  [[nodiscard]] double stable_time_step(std::span<const double> masses, std::span<const double> drive,
                                        std::span<const double> fractions);

  /// The site that this step comes from, the first of several; none if nothing moves. Arguments and
  /// exceptions as above.
  [[nodiscard]] std::optional<Index> limiting_site(std::span<const double> masses,
                                                   std::span<const double> drive,
                                                   std::span<const double> fractions);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

extern template class Segregation<1>;
extern template class Segregation<2>;
extern template class Segregation<3>;

}  // namespace scree::grainsize
