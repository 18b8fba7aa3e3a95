#include "scree/assemble/node_viscosity.hpp"

#include "scree/scene/dimensions.hpp"

#include <scree/rheology_stiff/implicit_viscosity.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>
#include <vector>

namespace scree::app {

namespace {

[[nodiscard]] std::size_t at(Index i) noexcept {
  return static_cast<std::size_t>(i);
}

/// A law without the viscous part of its stress. What that was made with is kept in a column.
template <int D, int V>
class WithoutViscosity final : public mpm::StressUpdate<D, V> {
 public:
  WithoutViscosity(std::unique_ptr<mpm::StressUpdate<D, V>> whole, mpm::Particles<D, V>& particles)
      : whole_{std::move(whole)},
        column_{particles.add_column({std::string{viscosity_column}, "mu", "Pa s"}, 1)} {}

  [[nodiscard]] std::string_view law() const noexcept override { return whole_->law(); }

  mpm::BlockStiffness apply(mpm::Particles<D, V>& particles, const mpm::ParticleBlock<D>& block,
                            double dt) const noexcept override {
    const mpm::BlockStiffness stiffness = whole_->apply(particles, block, dt);
    const auto viscosity = particles.column(column_).values();
    whole_->viscosity(particles, block, viscosity);
    for (Index p = block.begin; p < block.end; ++p) {
      if (!bears_stress(particles, p)) viscosity[at(p)] = 0;
      const Tensor<double> rate = deviator(symmetric_part(mpm::velocity_gradient_of(particles, p)));
      for (int j = 0; j < D; ++j) {
        for (int i = 0; i < V; ++i) {
          particles.stress.component(i + V * j)[p] -= 2 * viscosity[at(p)] * rate(at(i), at(j));
        }
      }
    }
    return without_viscosity(stiffness);
  }

  void pressure(const mpm::Particles<D, V>& particles, std::span<double> pressure) const noexcept override {
    whole_->pressure(particles, pressure);
  }
  void viscosity(const mpm::Particles<D, V>& particles, const mpm::ParticleBlock<D>& block,
                 std::span<double> viscosity) const noexcept override {
    whole_->viscosity(particles, block, viscosity);
  }
  [[nodiscard]] bool tells_stability() const noexcept override { return whole_->tells_stability(); }
  void stability_number(const mpm::Particles<D, V>& particles,
                        std::span<double> number) const noexcept override {
    whole_->stability_number(particles, number);
  }
  [[nodiscard]] double rest_pressure(const mpm::Particles<D, V>& particles, Index p,
                                     double density) const noexcept override {
    return whole_->rest_pressure(particles, p, density);
  }
  void require_inputs(const mpm::Particles<D, V>& particles) const override {
    whole_->require_inputs(particles);
  }
  void require_memory(const mpm::Particles<D, V>& particles) const override {
    whole_->require_memory(particles);
  }
  [[nodiscard]] mpm::BlockStiffness stiffness(const mpm::Particles<D, V>& particles, Index begin,
                                              Index end) const noexcept override {
    return without_viscosity(whole_->stiffness(particles, begin, end));
  }

 private:
  /// Material that is disconnected bears none, and so is not viscous.  Eq. (R5)
  [[nodiscard]] static bool bears_stress(const mpm::Particles<D, V>& particles, Index p) noexcept {
    for (int c = 0; c < V * D; ++c) {
      if (particles.stress.component(c)[p] != 0) return true;
    }
    return false;
  }

  [[nodiscard]] static mpm::BlockStiffness without_viscosity(mpm::BlockStiffness stiffness) noexcept {
    stiffness.kinematic_viscosity = 0;
    return stiffness;
  }

  std::unique_ptr<mpm::StressUpdate<D, V>> whole_;
  std::size_t column_;
};

/// The viscosity of points, on the nodes.  Eq. (M29)
template <int D, int V>
class ViscousNodes final : public mpm::NodeSolve<D, V> {
 public:
  ViscousNodes(const Scene& scene, const CartesianGrid<D>& grid, std::size_t column, Threads threads)
      : column_{column},
        solver_{grid, {.threads = threads}},
        mass_(at(grid.nodes().num_sites()), 0.0),
        velocity_(mass_.size() * V, 0.0),
        is_held_(mass_.size() * V, 0),
        viscosity_(at(grid.cells().num_sites()), 0.0) {
    for (int axis = 0; axis < D; ++axis) {
      const AxisScene& ends = scene.axes[at(axis)];
      if (ends.is_periodic) continue;
      hold(grid, axis, 0, ends.low);
      hold(grid, axis, grid.num_cells()[at(axis)], ends.high);
    }
  }

  void solve(const mpm::Particles<D, V>& particles, mpm::Nodes<D>& nodes, double dt,
             double mass_floor) override {
    gather_viscosity(particles, nodes.grid());
    constexpr int mass = mpm::NodeRecord::mass;
    constexpr int first = mpm::NodeRecord::momentum;
    for (std::size_t n = 0; n < mass_.size(); ++n) {
      const double* node = nodes[record_of(nodes, n)];
      mass_[n] = node[mass] > mass_floor ? node[mass] : 0;
      std::copy_n(node + first, V, velocity_.begin() + static_cast<Index>(n * V));
    }
    solver_.advance(velocity_, {mass_, is_held_}, viscosity_, dt);
    for (std::size_t n = 0; n < mass_.size(); ++n) {
      double* node = nodes[record_of(nodes, n)];
      for (int i = 0; i < V; ++i) {
        const double change = velocity_[n * V + at(i)] - node[first + i];
        node[first + i] += change;
        if (nodes.record().has_increment) node[nodes.record().increment() + i] += change;
      }
    }
  }

 private:
  /// What a wall holds of the nodes at `place` along `axis`.
  void hold(const CartesianGrid<D>& grid, int axis, Index place, const WallScene& wall) {
    const auto& holding = std::get<mpm::AnyWall>(wall);  // read_scene() admits no friction here
    const Lattice<D> nodes = grid.nodes();
    for (Index node = 0; node < nodes.num_sites(); ++node) {
      if (nodes.site(node)[at(axis)] != place) continue;
      for (int i = 0; i < V; ++i) {
        const bool holds = std::visit([&](const auto& rule) { return rule.holds(i, axis); }, holding);
        if (holds) is_held_[at(node * V + i)] = 1;
      }
    }
  }

  [[nodiscard]] static Index record_of(const mpm::Nodes<D>& nodes, std::size_t n) noexcept {
    const Indices<D> site = nodes.grid().nodes().site(static_cast<Index>(n));
    Index record = 0;
    for (std::size_t axis = 0; axis < D; ++axis) {
      record += nodes.place(site[axis], axis) * nodes.stride(axis);
    }
    return record;
  }

  void gather_viscosity(const mpm::Particles<D, V>& particles, const CartesianGrid<D>& grid) noexcept {
    std::ranges::fill(viscosity_, 0.0);
    const Lattice<D> cells = grid.cells();
    const double share = 1 / grid.spacing().prod();
    for (Index p = 0; p < particles.size(); ++p) {
      Indices<D> cell;
      for (std::size_t axis = 0; axis < D; ++axis) {
        const int a = static_cast<int>(axis);
        const double along = (particles.position.component(a)[p] - grid.origin()[a]) / grid.spacing()[a];
        const Index n = cells.count[axis];
        const auto place = static_cast<Index>(std::floor(along));
        cell[axis] = grid.is_periodic()[axis] ? (place % n + n) % n : std::clamp<Index>(place, 0, n - 1);
      }
      const double volume = particles.mass.component(0)[p] / particles.density.component(0)[p];
      viscosity_[at(cells.index(cell))] += share * volume * particles.column(column_).component(0)[p];
    }
  }

  std::size_t column_;
  rheology::ImplicitViscosity<D, V> solver_;
  std::vector<double> mass_;
  std::vector<double> velocity_;
  std::vector<std::uint8_t> is_held_;
  std::vector<double> viscosity_;
};

/// The steps that the material as it is allows.
struct StepLimits {
  double others;   ///< the shortest of all but viscosity's [s]
  double viscous;  ///< [s]; infinite if nothing is viscous
};

template <int D, int V>
[[nodiscard]] StepLimits step_limits(const Scene& scene, const CartesianGrid<D>& grid,
                                     const mpm::Particles<D, V>& particles, const mpm::Stages<D, V>& stages) {
  const mpm::BlockStiffness stiffness = stages.stress->stiffness(particles, 0, particles.size());
  const double others =
      mpm::stable_time_step(grid, {stiffness.wave_speed, 0, 0, stiffness.relaxation_rate}, scene.time_step)
          .dt;
  const double rate = 2 * stiffness.kinematic_viscosity * grid.spacing().cwiseInverse().squaredNorm();
  return {others, rate > 0 ? scene.time_step.viscous / rate : std::numeric_limits<double>::infinity()};
}

/// How many times as short explicit steps must be for a solve to pay, by dimension: it costs as much as 2, 12
/// and 35 explicit steps of points.
constexpr std::array<double, 3> solve_pays_from{3, 15, 40};

}  // namespace

template <int D, int V>
std::string choose_viscosity(const Scene& scene, const CartesianGrid<D>& grid,
                             mpm::Particles<D, V>& particles, mpm::Stages<D, V>& stages, Threads threads) {
  if (scene.viscosity == ViscosityScheme::with_stress) return {};
  std::string note;
  if (scene.viscosity == ViscosityScheme::automatic) {
    const StepLimits limits = step_limits(scene, grid, particles, stages);
    const double ratio = limits.others / limits.viscous;
    const double enough = solve_pays_from[at(D - 1)];
    const bool is_explicit = !(ratio > enough);
    std::ostringstream text;
    text.precision(3);
    text << "viscosity is " << (is_explicit ? "explicit" : "implicit") << ": the step of " << limits.others
         << " s is " << ratio << " times the viscous limit of " << limits.viscous << " s, "
         << (is_explicit ? "not above " : "above ") << enough;
    note = text.str();
    if (is_explicit) return note;
  }
  stages.stress = std::make_unique<WithoutViscosity<D, V>>(std::move(stages.stress), particles);
  stages.node_solve = std::make_unique<ViscousNodes<D, V>>(
      scene, grid, particles.find_column(viscosity_column, "implicit viscosity"), threads);
  return note;
}

#define SCREE_INSTANCE(D, V)                                                                          \
  template std::string choose_viscosity(const Scene&, const CartesianGrid<D>&, mpm::Particles<D, V>&, \
                                        mpm::Stages<D, V>&, Threads);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::app
