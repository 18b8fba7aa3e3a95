#pragma once

#include <scree/grainsize/segregation.hpp>
#include <scree/grainsize/segregation_law.hpp>
#include <scree/transport/grids/occupied_cells.hpp>
#include <scree/transport/reconstructions.hpp>
#include <scree/transport/solver.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <variant>
#include <vector>

namespace scree::grainsize::detail {

/// What a stepper is made of.
template <int D>
struct StepperParts {
  const SizeClasses& classes;
  const SegregationOptions& options;
  const Lattice<D>& lattice;
  const double* stretches;  ///< of faces along a radius, one per site [-]; none in plane flow
  Threads threads;
};

/// Segregation with the number of classes hidden: one virtual call per step.
template <int D>
class SegregationStepper {
 public:
  SegregationStepper() = default;
  SegregationStepper(const SegregationStepper&) = delete;
  SegregationStepper& operator=(const SegregationStepper&) = delete;
  SegregationStepper(SegregationStepper&&) = delete;
  SegregationStepper& operator=(SegregationStepper&&) = delete;
  virtual ~SegregationStepper() = default;

  /// @param drivers B at the face above each site, one row of num_sites per axis [m/s]
  virtual SegregationReport advance(std::span<const double> masses, std::span<const double> drivers,
                                    std::span<double> fractions, double dt) = 0;
  [[nodiscard]] virtual double stable_time_step(std::span<const double> masses,
                                                std::span<const double> drivers,
                                                std::span<const double> fractions) = 0;
  [[nodiscard]] virtual Index limiting_site(std::span<const double> masses, std::span<const double> drivers,
                                            std::span<const double> fractions) = 0;
};

/// The stepper for up to N classes.
template <int D, int N>
class SegregationStepperOf final : public SegregationStepper<D> {
 public:
  explicit SegregationStepperOf(const StepperParts<D>& parts)
      : num_classes_{parts.classes.size()},
        solver_{transport::OccupiedCells<D>{parts.lattice},
                law_for(parts),
                slopes_for(parts.options.limiter),
                parts.options.integrator,
                {.cfl = parts.options.cfl, .threads = parts.threads}},
        padded_(num_classes_ == N ? 0 : static_cast<std::size_t>(parts.lattice.num_sites()) * N) {}

  SegregationReport advance(std::span<const double> masses, std::span<const double> drivers,
                            std::span<double> fractions, double dt) override {
    set(masses, drivers);
    if (num_classes_ == N) return report(solver_.advance(fractions, dt));
    pad(fractions);
    const transport::Advance result = solver_.advance(padded_, dt);
    unpad(fractions);
    return report(result);
  }

  [[nodiscard]] double stable_time_step(std::span<const double> masses, std::span<const double> drivers,
                                        std::span<const double> fractions) override {
    set(masses, drivers);
    if (num_classes_ == N) return solver_.stable_time_step(fractions);
    pad(fractions);
    return solver_.stable_time_step(padded_);
  }

  [[nodiscard]] Index limiting_site(std::span<const double> masses, std::span<const double> drivers,
                                    std::span<const double> fractions) override {
    set(masses, drivers);
    if (num_classes_ == N) return solver_.limiting_site(fractions);
    pad(fractions);
    return solver_.limiting_site(padded_);
  }

 private:
  using Slopes = transport::WithAnyLimiter<transport::PiecewiseLinearCommon<transport::Minmod>>;

  /// The scale below whose round-off a class is noise: the tail of one that is gone must not flatten the
  /// rest.
  static constexpr double largest_fraction = 1;

  static SegregationLaw<N> law_for(const StepperParts<D>& parts) {
    SegregationLaw<N> law{.inverse_sizes = {},
                          .remixing = parts.options.remixing,
                          .drivers = nullptr,
                          .num_sites = parts.lattice.num_sites(),
                          .stretches = parts.stretches};
    law.inverse_sizes.fill(1 / parts.classes.largest());
    std::ranges::transform(parts.classes.diameters(), law.inverse_sizes.begin(),
                           [](double s) { return 1 / s; });
    return law;
  }

  static Slopes slopes_for(const transport::AnyLimiter& any) {
    return std::visit(
        []<class Limiter>(const Limiter& limiter) -> Slopes {
          return {transport::PiecewiseLinearCommon<Limiter>{.limiter = limiter, .scale = largest_fraction}};
        },
        any);
  }

  static SegregationReport report(const transport::Advance& result) {
    return {result.substeps, result.largest_speed, result.stable_dt};
  }

  void set(std::span<const double> masses, std::span<const double> drivers) {
    solver_.grid().set_masses(masses);
    solver_.law().drivers = drivers.data();
  }

  void pad(std::span<const double> fractions) {
    for (std::size_t site = 0; site * N < padded_.size(); ++site) {
      std::ranges::copy(fractions.subspan(site * num_classes_, num_classes_), padded_.begin() + offset(site));
    }
  }

  void unpad(std::span<double> fractions) const {
    for (std::size_t site = 0; site * N < padded_.size(); ++site) {
      std::ranges::copy_n(padded_.begin() + offset(site), static_cast<Index>(num_classes_),
                          fractions.subspan(site * num_classes_).begin());
    }
  }

  static Index offset(std::size_t site) { return static_cast<Index>(site * N); }

  std::size_t num_classes_;
  transport::Solver<transport::OccupiedCells<D>, SegregationLaw<N>, Slopes> solver_;
  std::vector<double> padded_;  // num_sites x N; its classes beyond num_classes stay empty
};

}  // namespace scree::grainsize::detail
