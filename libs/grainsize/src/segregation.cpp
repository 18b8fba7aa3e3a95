#include "checks.hpp"
#include "segregation_steppers.hpp"

#include <scree/grainsize/segregation.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace scree::grainsize {

namespace {

/// CFL number up to which coupled fractions keep their bounds [-].  Eq. (G18)
constexpr double largest_cfl = 0.5;

template <int D>
void require_valid(const SizeClasses& classes, const SegregationOptions& options, const Lattice<D>& lattice,
                   const Vector<D>& gravity_direction) {
  if (classes.size() > Segregation<D>::max_num_classes) {
    throw InputError{detail::message("Segregation: there are ", classes.size(), " size classes, but at most ",
                                     Segregation<D>::max_num_classes, " are possible")};
  }
  if (!(options.remixing >= 0 && std::isfinite(options.remixing))) {
    throw InputError{detail::message("Segregation: the remixing is ", options.remixing,
                                     " m^2/s, but must be zero or positive, and finite")};
  }
  if (!(options.cfl > 0 && options.cfl <= largest_cfl)) {
    throw InputError{detail::message("Segregation: the CFL number is ", options.cfl, ", but must lie in (0, ",
                                     largest_cfl, "]")};
  }
  require(options.symmetry == Symmetry::plane || !lattice.is_periodic[0],
          "Segregation: axis 0 is the radius of a flow round an axis and cannot be periodic");
  const double length = gravity_direction.norm();
  if (length == 0) {
    require(!std::holds_alternative<Gravity>(options.closure),
            "Segregation: the closure gravity needs a direction of gravity, but there is none");
  } else if (!(std::abs(length - 1) <= 4 * D * round_off)) {
    throw InputError{detail::message("Segregation: the direction of gravity has the length ", length,
                                     ", but must be a unit vector or zero")};
  }
}

void require_length(std::string_view what, std::size_t length, std::size_t expected) {
  if (length != expected) {
    throw InputError{
        detail::message("Segregation: ", expected, " ", what, " are needed, but ", length, " are given")};
  }
}

template <int D>
std::unique_ptr<detail::SegregationStepper<D>> choose_stepper(const detail::StepperParts<D>& parts) {
  const std::size_t num_classes = parts.classes.size();
  if (num_classes <= 2) return detail::make_stepper<D, 2>(parts);
  if (num_classes <= 4) return detail::make_stepper<D, 4>(parts);
  if (num_classes <= 8) return detail::make_stepper<D, 8>(parts);
  return detail::make_stepper<D, 16>(parts);
}

}  // namespace

/// What does not depend on the number of classes: the checks, and the driver at every face.
template <int D>
class Segregation<D>::Implementation {
 public:
  Implementation(const SizeClasses& classes, const SegregationOptions& options, const Lattice<D>& lattice,
                 const Vector<D>& gravity_direction, Threads threads)
      : lattice_{lattice},
        num_classes_{classes.size()},
        closure_{options.closure},
        gravity_direction_{gravity_direction},
        threads_{threads},
        drivers_(D * num_sites()),
        stretches_(options.symmetry == Symmetry::axial ? num_sites() : 0),
        stepper_{choose_stepper<D>(
            {classes, options, lattice, stretches_.empty() ? nullptr : stretches_.data(), threads})} {}

  /// Sets the driver at every face of the lattice.
  void set_drivers(std::span<const double> masses, std::span<const double> drive) {
    std::visit([&](const auto& closure) { set_drivers(closure, drive); }, closure_);
    if (!stretches_.empty()) stretch_radial_faces(masses);
  }

  void require_lengths(std::size_t num_masses, std::size_t num_drives, std::size_t num_fractions) const {
    require_length("masses", num_masses, num_sites());
    require_length("drives", num_drives, num_sites());
    require_length("fractions", num_fractions, num_sites() * num_classes_);
  }

  [[nodiscard]] std::span<const double> drivers() const noexcept { return drivers_; }
  [[nodiscard]] detail::SegregationStepper<D>& stepper() noexcept { return *stepper_; }

 private:
  [[nodiscard]] std::size_t num_sites() const noexcept {
    return static_cast<std::size_t>(lattice_.num_sites());
  }

  template <Closure C>
  void set_drivers(const C& closure, std::span<const double> drive) {
    constexpr Index chunk = 4096;
    const Index n = lattice_.num_sites();
    for_each_block((n + chunk - 1) / chunk, threads_, [&](Index block) {
      for (Index site = block * chunk; site < std::min(n, (block + 1) * chunk); ++site) {
        for (int axis = 0; axis < D; ++axis) {
          drivers_[static_cast<std::size_t>(axis * n + site)] = driver_above(closure, drive, site, axis);
        }
      }
    });
  }

  /// B along +axis at the face above `site` [m/s]; zero where a wall is.
  template <Closure C>
  [[nodiscard]] double driver_above(const C& closure, std::span<const double> drive, Index site,
                                    int axis) const noexcept {
    const auto a = static_cast<std::size_t>(axis);
    const Index stride = lattice_.stride(axis);
    const bool is_last = (site / stride) % lattice_.count[a] == lattice_.count[a] - 1;
    if (is_last && !lattice_.is_periodic[a]) return 0;
    const Index neighbour = is_last ? site - (lattice_.count[a] - 1) * stride : site + stride;
    return closure.velocity({.left = drive[static_cast<std::size_t>(site)],
                             .right = drive[static_cast<std::size_t>(neighbour)],
                             .distance = lattice_.spacing[axis],
                             .gravity = gravity_direction_[axis]});
  }

  /// Makes the balance of a radian out of one over the same lattice in plane flow: through a face along the
  /// radius goes more than the lighter of its sides, each with its own radius, would let pass.  Eq. (M181)
  void stretch_radial_faces(std::span<const double> masses) noexcept {
    const Index last = lattice_.count[0] - 1;
    for (std::size_t site = 0; site < stretches_.size(); ++site) {
      const Indices<D> here = lattice_.site(static_cast<Index>(site));
      stretches_[site] = 1;
      if (here[0] == last || !(masses[site] > 0 && masses[site + 1] > 0)) continue;
      Indices<D> above = here;
      ++above[0];
      const double inner = masses[site] / lattice_.volume(here);
      const double outer = masses[site + 1] / lattice_.volume(above);
      const double lighter =
          std::min(inner / middle_radius(lattice_, here[0]), outer / middle_radius(lattice_, above[0]));
      stretches_[site] = radius_above(lattice_, here[0]) * lighter / std::min(inner, outer);
      drivers_[site] *= stretches_[site];
    }
  }

  Lattice<D> lattice_;
  std::size_t num_classes_;
  AnyClosure closure_;
  Vector<D> gravity_direction_;
  Threads threads_;
  std::vector<double> drivers_;    // [m/s], one row of num_sites per axis
  std::vector<double> stretches_;  // [-], of faces above sites along a radius; none in plane flow
  std::unique_ptr<detail::SegregationStepper<D>> stepper_;
};

template <int D>
Segregation<D>::Segregation(const SizeClasses& classes, const SegregationOptions& options,
                            const Lattice<D>& lattice, const Vector<D>& gravity_direction, Threads threads) {
  require_valid<D>(classes, options, lattice, gravity_direction);
  implementation_ = std::make_unique<Implementation>(classes, options, lattice, gravity_direction, threads);
}

template <int D>
Segregation<D>::~Segregation() = default;
template <int D>
Segregation<D>::Segregation(Segregation&&) noexcept = default;
template <int D>
Segregation<D>& Segregation<D>::operator=(Segregation&&) noexcept = default;

template <int D>
SegregationReport Segregation<D>::advance(std::span<const double> masses, std::span<const double> drive,
                                          std::span<double> fractions, double dt) {
  implementation_->require_lengths(masses.size(), drive.size(), fractions.size());
  if (!(dt >= 0 && std::isfinite(dt))) {
    throw InputError{
        detail::message("Segregation: the step is ", dt, " s, but must be zero or positive, and finite")};
  }
  implementation_->set_drivers(masses, drive);
  return implementation_->stepper().advance(masses, implementation_->drivers(), fractions, dt);
}

template <int D>
double Segregation<D>::stable_time_step(std::span<const double> masses, std::span<const double> drive,
                                        std::span<const double> fractions) {
  implementation_->require_lengths(masses.size(), drive.size(), fractions.size());
  implementation_->set_drivers(masses, drive);
  return implementation_->stepper().stable_time_step(masses, implementation_->drivers(), fractions);
}

template <int D>
std::optional<Index> Segregation<D>::limiting_site(std::span<const double> masses,
                                                   std::span<const double> drive,
                                                   std::span<const double> fractions) {
  implementation_->require_lengths(masses.size(), drive.size(), fractions.size());
  implementation_->set_drivers(masses, drive);
  const Index site = implementation_->stepper().limiting_site(masses, implementation_->drivers(), fractions);
  return site == transport::no_site ? std::nullopt : std::optional{site};
}

template class Segregation<1>;
template class Segregation<2>;
template class Segregation<3>;

}  // namespace scree::grainsize
