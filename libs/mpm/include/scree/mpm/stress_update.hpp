#pragma once

#include <scree/constitutive_law.hpp>
#include <scree/mpm/law_inputs.hpp>
#include <scree/mpm/particle_blocks.hpp>
#include <scree/mpm/particles.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace scree::mpm {

/// The largest speed, viscosity and rate met in a block: what bounds the next step; and what its law could
/// not solve.
struct BlockStiffness {
  double wave_speed = 0;           ///< [m/s]
  double kinematic_viscosity = 0;  ///< viscosity over density [m^2/s]
  double relaxation_rate = 0;      ///< [1/s]
  double unsolved = 0;             ///< worst of its points, `Response::unsolved` [-]
  Index unsolved_point = -1;       ///< that point
};

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

  /// Writes the stress column of the block, and the law's state.
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

  /// Density at which a point at rest has the given pressure, for initial states [kg/m^3].
  /// @param wanted pressure [Pa], not negative
  /// @throws RunError naming the law if it has no such density.
  [[nodiscard]] virtual double density_at(const Particles<D, V>& particles, Index p, double wanted) const = 0;

  /// What the points as they are would bound a step by; changes nothing.
  [[nodiscard]] virtual BlockStiffness stiffness(const Particles<D, V>& particles) const noexcept = 0;
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

/// The stress update by one constitutive law. Its inputs are columns found by name when it is built (one that
/// is absent, in another unit or somewhere out of its range is an InputError), its state becomes columns of
/// their own, which begin at the law's initial values.
template <int D, int V, ConstitutiveLaw Law>
class StressUpdateBy final : public StressUpdate<D, V> {
 public:
  StressUpdateBy(const Law& law, Particles<D, V>& particles) : law_{law} {
    for (std::size_t i = 0; i < num_inputs; ++i) {
      inputs_[i] = input_column(particles, Law::inputs[i]);
      require_in_range(particles, inputs_[i], Law::inputs[i], Law::name);
    }
    for (std::size_t i = 0; i < num_states; ++i) {
      states_[i] = state_column(particles, Law::states[i]);
    }
  }

  [[nodiscard]] std::string_view law() const noexcept override { return Law::name; }

  BlockStiffness apply(Particles<D, V>& particles, const ParticleBlock<D>& block,
                       double dt) const noexcept override {
    BlockStiffness worst;
    for (Index p = block.begin; p < block.end; ++p) {
      const Deformation<double> deformation = deformation_of(particles, p);
      const Input input = load<Input>(particles, inputs_, p);
      const auto response = law_.update(deformation, input, load<State>(particles, states_, p), dt);
      for (int j = 0; j < D; ++j) {
        for (int i = 0; i < V; ++i) {
          particles.stress.component(i + V * j)[p] =
              response.stress(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
        }
      }
      store(particles, response.state, p);
      widen(worst, deformation, input, response.state);
      if (response.unsolved > worst.unsolved) {
        worst.unsolved = response.unsolved;
        worst.unsolved_point = p;
      }
    }
    return worst;
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

  /// By the secant rule; a linear equation of state takes one step.
  [[nodiscard]] double density_at(const Particles<D, V>& particles, Index p, double wanted) const override {
    constexpr int max_iterations = 50;
    const double start = particles.density.component(0)[p];
    const double tolerance = 4 * round_off * start;
    const Input input = load<Input>(particles, inputs_, p);
    const auto excess = [&](double density) {
      const auto response =
          law_.update({Tensor<double>{}, density}, input, load<State>(particles, states_, p), 0.0);
      return -trace(response.stress) / 3 - wanted;
    };
    double previous = start;
    double density = start * (1 + 1e-3);  // compressed, so that no law has let go
    for (int i = 0; i < max_iterations; ++i) {
      const double at_previous = excess(previous);
      const double at_density = excess(density);
      if (at_density == 0 || std::abs(density - previous) <= tolerance) return density;
      const double next = density - at_density * (density - previous) / (at_density - at_previous);
      if (!std::isfinite(next)) break;
      previous = std::exchange(density, next);
    }
    throw RunError{"the law '" + std::string{Law::name} + "' has no density at which its pressure is " +
                   std::to_string(wanted) + " Pa"};
  }

  [[nodiscard]] BlockStiffness stiffness(const Particles<D, V>& particles) const noexcept override {
    BlockStiffness worst;
    for (Index p = 0; p < particles.size(); ++p) {
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

  [[nodiscard]] static std::size_t input_column(const Particles<D, V>& particles, const InputColumn& input) {
    const std::string law = "the law '" + std::string{Law::name} + "'";
    const std::size_t index = particles.find_column(input.name, law);
    const std::string& unit = particles.column(index).quantity().unit;
    require(unit == input.unit, law + " reads the column '" + std::string{input.name} + "' in " +
                                    std::string{input.unit} + ", but it is in " + unit);
    return index;
  }

  [[nodiscard]] static std::size_t state_column(Particles<D, V>& particles, const StateColumn& state) {
    const std::string name{state.name};
    const std::size_t index = particles.add_column({name, name, std::string{state.unit}}, 1);
    std::ranges::fill(particles.column(index).values(), state.initial);
    return index;
  }

  [[nodiscard]] static Deformation<double> deformation_of(const Particles<D, V>& particles,
                                                          Index p) noexcept {
    return {velocity_gradient_of(particles, p), particles.density.component(0)[p]};
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

  void store(Particles<D, V>& particles, const State& state, Index p) const noexcept {
    if constexpr (num_states > 0) {
      const auto values = std::bit_cast<std::array<double, num_states>>(state);
      for (std::size_t i = 0; i < num_states; ++i) particles.column(states_[i]).component(0)[p] = values[i];
    }
  }

  void widen(BlockStiffness& worst, const Deformation<double>& deformation, const Input& input,
             const State& state) const noexcept {
    const Stiffness<double> here = law_.stiffness(deformation, input, state);
    worst.wave_speed = std::max(worst.wave_speed, here.wave_speed);
    worst.kinematic_viscosity = std::max(worst.kinematic_viscosity, here.viscosity / deformation.density);
    worst.relaxation_rate = std::max(worst.relaxation_rate, here.relaxation_rate);
  }

  Law law_;
  std::array<std::size_t, num_inputs> inputs_{};
  std::array<std::size_t, num_states> states_{};
};

}  // namespace scree::mpm
