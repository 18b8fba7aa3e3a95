#pragma once

#include <scree/mpm/hoop_columns.hpp>
#include <scree/mpm/law_inputs.hpp>
#include <scree/mpm/particle_blocks.hpp>
#include <scree/mpm/particles.hpp>
#include <scree/rest_density.hpp>
#include <scree/update_block.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <string>
#include <string_view>

namespace scree::mpm {

using scree::BlockStiffness;

/// Brings the stress of a block's points up to date with their motion; the law is chosen once, in here.
template <int D, int V>
class StressUpdate {
 public:
  StressUpdate() = default;
  StressUpdate(const StressUpdate&) = delete;
  StressUpdate& operator=(const StressUpdate&) = delete;
  virtual ~StressUpdate() = default;

  /// Name of the law.
  [[nodiscard]] virtual std::string_view law() const noexcept = 0;

  /// Writes the stress column of the block, and the law's state.  @param dt [s]
  virtual BlockStiffness apply(Particles<D, V>& particles, const ParticleBlock<D>& block,
                               double dt) const noexcept = 0;

  /// Pressure of every point, for output: -tr(sigma)/3 of the whole 3x3 stress; changes nothing.
  /// @param pressure one per point [Pa]
  virtual void pressure(const Particles<D, V>& particles, std::span<double> pressure) const noexcept = 0;

  /// Writes the law's effective viscosity at the points of a block [Pa s]; changes nothing else.
  /// @param viscosity one per point, all points
  virtual void viscosity(const Particles<D, V>& particles, const ParticleBlock<D>& block,
                         std::span<double> viscosity) const noexcept = 0;

  /// Whether the law can tell where its equations are ill-posed.
  [[nodiscard]] virtual bool tells_stability() const noexcept = 0;

  /// The law's stability number C of every point, for output; ill-posed where it is positive. Zero for a law
  /// that cannot tell. Changes nothing.
  /// @param number one per point [-]
  virtual void stability_number(const Particles<D, V>& particles,
                                std::span<double> number) const noexcept = 0;

  /// Pressure that a point would have at rest with another density, for initial states [Pa]; changes nothing.
  /// @param density [kg/m^3], positive
  [[nodiscard]] virtual double rest_pressure(const Particles<D, V>& particles, Index p,
                                             double density) const noexcept = 0;

  /// Density at which a point at rest has the given pressure, for initial states [kg/m^3].
  /// @param wanted pressure [Pa], not negative
  /// @throws RunError naming the law if it has no such density.
  [[nodiscard]] double density_at(const Particles<D, V>& particles, Index p, double wanted) const {
    const auto excess = [&](double density) { return rest_pressure(particles, p, density) - wanted; };
    if (const auto density = rest_density(excess, particles.density.component(0)[p])) return *density;
    throw RunError{"the law '" + std::string{law()} + "' has no density at which its pressure is " +
                   std::to_string(wanted) + " Pa"};
  }

  /// Checks what the law reads of each point that has mass; for when inputs have changed.
  /// @throws InputError as require_in_range() does.
  virtual void require_inputs(const Particles<D, V>& particles) const = 0;

  /// Checks that memory which a flow in a plane lacks, and its form of a law does not read, is 0; for when
  /// memory comes from elsewhere.
  /// @throws InputError as require_in_range() does.
  virtual void require_memory(const Particles<D, V>& particles) const = 0;

  /// What the points begin..end-1 as they are would bound a step by; changes nothing.
  [[nodiscard]] virtual BlockStiffness stiffness(const Particles<D, V>& particles, Index begin,
                                                 Index end) const noexcept = 0;
};

/// The velocity gradient of a point as a 3x3 tensor, its missing components zero.
template <int D, int V>
[[nodiscard]] Tensor<double> velocity_gradient_of(const Particles<D, V>& particles, Index p) noexcept {
  Tensor<double> gradient;
  for (int j = 0; j < D; ++j) {
    for (int i = 0; i < V; ++i) {
      gradient(static_cast<std::size_t>(i), static_cast<std::size_t>(j)) =
          particles.velocity_gradient.component(i + V * j)[p];
    }
  }
  return gradient;
}

namespace detail {

/// StressUpdate::rest_pressure() of a point, which all dimensions share.
template <class Law>
[[nodiscard]] double rest_pressure(const Law& law, const typename Law::template Input<double>& input,
                                   const typename Law::template State<double>& state,
                                   double density) noexcept {
  return -trace(law.update({Tensor<double>{}, density}, input, state, 0.0).stress) / 3;
}

}  // namespace detail

/// The stress update by one constitutive law. Its inputs are columns found by name when it is built (one that
/// is absent, in another unit or somewhere out of its range is an InputError), its state becomes columns of
/// their own, which begin at the law's initial values.
template <int D, int V, ConstitutiveLaw Law>
class StressUpdateBy final : public StressUpdate<D, V> {
 public:
  /// @param set what the law's kernel is compiled for, if it has kernels; must run here
  StressUpdateBy(const Law& law, Particles<D, V>& particles, InstructionSet set = widest_instruction_set())
      : StressUpdateBy{law, particles, kernel_of(law, set)} {}

  /// The same with a kernel that is known: what the law is without one, point by point, need not be compiled.
  /// @param kernel of this law; not null
  StressUpdateBy(const Law& law, Particles<D, V>& particles, BlockKernel<Law> kernel)
      : law_{law}, kernel_{kernel}, hoop_{hoop_columns_of(particles)} {
    SCREE_ASSERT(kernel != nullptr);
    for (std::size_t i = 0; i < num_inputs; ++i) {
      inputs_[i] = input_column(particles, Law::inputs[i], Law::name);
    }
    StressUpdateBy::require_inputs(particles);
    for (std::size_t i = 0; i < num_states; ++i) {
      states_[i] = state_column(particles, Law::states[i]);
    }
  }

  [[nodiscard]] std::string_view law() const noexcept override { return Law::name; }

  BlockStiffness apply(Particles<D, V>& particles, const ParticleBlock<D>& block,
                       double dt) const noexcept override {
    SCREE_ASSERT((block.end - block.begin) % pack_size == 0);
    BlockStiffness worst = kernel_(law_, columns_of(particles, block), dt);
    if (worst.unsolved > 0) worst.unsolved_point += block.begin;
    return worst;
  }

  void require_inputs(const Particles<D, V>& particles) const override {
    for (std::size_t i = 0; i < num_inputs; ++i) {
      require_in_range(particles, inputs_[i], Law::inputs[i], Law::name);
    }
  }

  void require_memory([[maybe_unused]] const Particles<D, V>& particles) const override {
    if constexpr (HasPlaneForm<Law> && V < 3) {
      for (std::size_t i = 0; i < num_states; ++i) {
        if (std::ranges::find(Law::plane_states, i) != Law::plane_states.end()) continue;
        const std::string name = std::string{Law::states[i].name} + " (which a flow in a plane lacks)";
        require_in_range(particles, states_[i], {name, Law::states[i].unit, 0, Interval{0, 0, false}},
                         Law::name);
      }
    }
  }

  void pressure(const Particles<D, V>& particles, std::span<double> pressure) const noexcept override {
    for (Index p = 0; p < particles.size(); ++p) {
      const auto response = law_.update(deformation_of(particles, p), load<Input>(particles, inputs_, p),
                                        load<State>(particles, states_, p), 0.0);
      pressure[static_cast<std::size_t>(p)] = -trace(response.stress) / 3;
    }
  }

  void viscosity(const Particles<D, V>& particles, const ParticleBlock<D>& block,
                 std::span<double> viscosity) const noexcept override {
    for (Index p = block.begin; p < block.end; ++p) {
      viscosity[static_cast<std::size_t>(p)] =
          law_.stiffness(deformation_of(particles, p), load<Input>(particles, inputs_, p),
                         load<State>(particles, states_, p))
              .viscosity;
    }
  }

  [[nodiscard]] bool tells_stability() const noexcept override { return tells; }

  void stability_number(const Particles<D, V>& particles, std::span<double> number) const noexcept override {
    for (Index p = 0; p < particles.size(); ++p) {
      if constexpr (tells) {
        number[static_cast<std::size_t>(p)] =
            law_.stability_number(deformation_of(particles, p), load<Input>(particles, inputs_, p),
                                  load<State>(particles, states_, p));
      } else {
        number[static_cast<std::size_t>(p)] = 0;
      }
    }
  }

  [[nodiscard]] double rest_pressure(const Particles<D, V>& particles, Index p,
                                     double density) const noexcept override {
    return detail::rest_pressure(law_, load<Input>(particles, inputs_, p), load<State>(particles, states_, p),
                                 density);
  }

  [[nodiscard]] BlockStiffness stiffness(const Particles<D, V>& particles, Index begin,
                                         Index end) const noexcept override {
    BlockStiffness worst;
    for (Index p = begin; p < end; ++p) {
      widen(worst, deformation_of(particles, p), load<Input>(particles, inputs_, p),
            load<State>(particles, states_, p));
    }
    return worst;
  }

 private:
  using Input = typename Law::template Input<double>;
  using State = typename Law::template State<double>;
  static constexpr bool tells = requires(const Law& law, const Deformation<double>& deformation,
                                         const Input& input, const State& state) {
    law.stability_number(deformation, input, state);
  };
  static constexpr std::size_t num_inputs = Law::inputs.size();
  static constexpr std::size_t num_states = Law::states.size();

  [[nodiscard]] Deformation<double> deformation_of(const Particles<D, V>& particles, Index p) const noexcept {
    Deformation<double> deformation{velocity_gradient_of(particles, p), particles.density.component(0)[p]};
    if (hoop_) deformation.velocity_gradient(2, 2) = particles.column(hoop_->rate).component(0)[p];
    return deformation;
  }

  /// An aggregate of doubles, each from its column.
  template <class Aggregate, std::size_t N>
  [[nodiscard]] static Aggregate load(const Particles<D, V>& particles,
                                      const std::array<std::size_t, N>& columns, Index p) noexcept {
    if constexpr (N == 0) {
      return Aggregate{};
    } else {
      std::array<double, N> values;
      for (std::size_t i = 0; i < N; ++i) values[i] = particles.column(columns[i]).component(0)[p];
      return std::bit_cast<Aggregate>(values);
    }
  }

  /// What the law's kernel reads and writes. Components that space or velocity lack are read as zeros.
  [[nodiscard]] LawBlock<Law> columns_of(Particles<D, V>& particles,
                                         const ParticleBlock<D>& block) const noexcept {
    LawBlock<Law> columns;
    columns.num_points = block.end - block.begin;
    for (int j = 0; j < D; ++j) {
      for (int i = 0; i < V; ++i) {
        const std::size_t row_by_row = 3 * static_cast<std::size_t>(i) + static_cast<std::size_t>(j);
        columns.velocity_gradient[row_by_row] = {
            particles.velocity_gradient.component(i + V * j) + block.begin, 1};
        columns.stress[row_by_row] = particles.stress.component(i + V * j) + block.begin;
      }
    }
    if (hoop_) {
      columns.velocity_gradient[8] = {particles.column(hoop_->rate).component(0) + block.begin, 1};
      columns.stress[8] = particles.column(hoop_->stress).component(0) + block.begin;
    }
    columns.density = particles.density.component(0) + block.begin;
    for (std::size_t i = 0; i < num_inputs; ++i) {
      columns.inputs[i] = particles.column(inputs_[i]).component(0) + block.begin;
    }
    for (std::size_t i = 0; i < num_states; ++i) {
      columns.states[i] = particles.column(states_[i]).component(0) + block.begin;
    }
    return columns;
  }

  void widen(BlockStiffness& worst, const Deformation<double>& deformation, const Input& input,
             const State& state) const noexcept {
    const Stiffness<double> here = law_.stiffness(deformation, input, state);
    worst.widen({here.wave_speed, here.viscosity / deformation.density, here.relaxation_rate});
  }

  Law law_;
  BlockKernel<Law> kernel_;
  std::optional<HoopColumns> hoop_;
  std::array<std::size_t, num_inputs> inputs_{};
  std::array<std::size_t, num_states> states_{};
};

}  // namespace scree::mpm
