#include "scree/run/coupling.hpp"

#include "scree/scene/dimensions.hpp"
#include "scree/scene/material_columns.hpp"

#include <scree/io/bounds.hpp>
#include <scree/mpm/axisymmetric.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace scree::app {

template <int D, int V>
void observe_fractions(const mpm::Particles<D, V>& particles, FractionExtremes& extremes) {
  const mpm::Column& fractions = particles.column(particles.find_column(fraction_column, "the summary"));
  for (Index p = 0; p < particles.size(); ++p) {
    double sum = 0;
    for (int k = 0; k < fractions.num_components(); ++k) {
      const double phi = fractions.component(k)[p];
      extremes.lowest = std::min(extremes.lowest, phi);
      extremes.highest = std::max(extremes.highest, phi);
      sum += phi;
    }
    extremes.sum_error = std::max(extremes.sum_error, std::abs(sum - 1));
  }
}

template <int D, int V>
std::vector<double> class_masses(const mpm::Particles<D, V>& particles) {
  const mpm::Column& fractions = particles.column(particles.find_column(fraction_column, "the summary"));
  std::vector<double> masses;
  for (int k = 0; k < fractions.num_components(); ++k) {
    double sum = 0;
    for (Index p = 0; p < particles.size(); ++p) {
      sum += particles.mass.component(0)[p] * fractions.component(k)[p];
    }
    masses.push_back(sum);
  }
  return masses;
}

template <int D, int V>
Coupling<D, V>::Coupling(const SegregationScene& scene, const grainsize::SizeClasses& classes,
                         const CartesianGrid<D>& grid, const mpm::AnyShape& shape,
                         const Vector<D>& gravity_direction, Symmetry symmetry, Threads threads)
    : classes_{classes},
      closure_{scene.closure},
      map_{scene.map},
      threads_{threads},
      cells_{grid, scene.control_volumes, shape},
      segregation_{classes,
                   {.closure = scene.closure,
                    .remixing = scene.remixing,
                    .limiter = scene.limiter,
                    .integrator = scene.integrator,
                    .cfl = scene.cfl,
                    .symmetry = symmetry},
                   cells_.lattice(),
                   gravity_direction,
                   threads} {
  const auto num_sites = static_cast<std::size_t>(cells_.lattice().num_sites());
  masses_.resize(num_sites);
  drive_.resize(num_sites);
  means_.resize(num_sites * (classes.size() + 1));
  old_fractions_.resize(num_sites * classes.size());
  new_fractions_.resize(num_sites * classes.size());
}

template <int D, int V>
void Coupling<D, V>::drive_of_points(const mpm::Particles<D, V>& particles) {
  if (point_drive_.size() != particles.size()) point_drive_.resize(particles.size());
  const double* size = particles.column(particles.find_column(grain_size_column, "segregation")).component(0);
  double* drive = point_drive_.component(0);
  const auto hoop = mpm::hoop_columns_of(particles);
  std::visit(
      [&](const auto& closure) {
        for (Index p = 0; p < particles.size(); ++p) {
          drive[p] = closure.drive(shear_rate(mpm::velocity_gradient_of(particles, p, hoop)), size[p]);
        }
      },
      closure_);
}

template <int D, int V>
void Coupling<D, V>::to_sites(const mpm::State<D, V>& state, const mpm::Column& fractions) {
  const std::size_t num_classes = classes_.size();
  std::vector<mpm::CarriedField> fields{{&point_drive_, 0}};
  for (int k = 0; k < fractions.num_components(); ++k) fields.push_back({&fractions, k});
  cells_.to_sites(state.particles, state.blocks, fields, masses_, means_, threads_);
  for (std::size_t site = 0; site < masses_.size(); ++site) {
    const double* means = means_.data() + site * (num_classes + 1);
    drive_[site] = means[0];
    std::copy(means + 1, means + 1 + num_classes, old_fractions_.data() + site * num_classes);
  }
}

template <int D, int V>
void Coupling<D, V>::require_few_substeps(double dt) {
  constexpr double most = 1e5;  // [-], many times what any flow needs whose velocities make sense
  const double stable = segregation_.stable_time_step(masses_, drive_, old_fractions_);
  if (dt <= most * stable) return;
  throw RunError{fmt::format(
      "segregation is so fast that its stable step has fallen to {} s, at ({:.6g}) m: the run has become "
      "unstable; use a smaller share of the limits ([numerics])",
      io::to_text(stable), fmt::join(limit()->position, ", "))};
}

template <int D, int V>
std::optional<SegregationLimit<D>> Coupling<D, V>::limit() {
  const auto site = segregation_.limiting_site(masses_, drive_, old_fractions_);
  if (!site) return std::nullopt;
  const Lattice<D>& lattice = cells_.lattice();
  return SegregationLimit<D>{segregation_.stable_time_step(masses_, drive_, old_fractions_),
                             lattice.position(lattice.site(*site))};
}

template <int D, int V>
std::optional<SegregationLimit<D>> Coupling<D, V>::last_limit() {
  return has_advanced_ ? limit() : std::nullopt;
}

template <int D, int V>
grainsize::SegregationReport Coupling<D, V>::advance(mpm::State<D, V>& state, double dt) {
  mpm::Particles<D, V>& particles = state.particles;
  mpm::Column& fractions = particles.column(particles.find_column(fraction_column, "segregation"));
  has_advanced_ = false;
  drive_of_points(particles);
  to_sites(state, fractions);
  require_few_substeps(dt);
  new_fractions_ = old_fractions_;
  const auto report = segregation_.advance(masses_, drive_, new_fractions_, dt);
  cells_.to_points(state.blocks, particles, fractions, old_fractions_, new_fractions_, map_, threads_);
  has_advanced_ = true;
  return report;
}

#define SCREE_INSTANCE(D, V)                                                       \
  template void observe_fractions(const mpm::Particles<D, V>&, FractionExtremes&); \
  template std::vector<double> class_masses(const mpm::Particles<D, V>&);          \
  template class Coupling<D, V>;
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::app
