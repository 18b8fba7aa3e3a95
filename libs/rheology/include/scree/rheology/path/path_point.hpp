#pragma once

#include <scree/rheology/columns.hpp>
#include <scree/rheology/concepts.hpp>
#include <scree/rheology/inertial_number.hpp>
#include <scree/rheology/stress_measures.hpp>

#include <array>
#include <bit>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

namespace scree::rheology {

/// What a point is in between two steps, beside the memory of its law.
struct PathState {
  double time = 0;          ///< [s]
  double density = 0;       ///< [kg/m^3]
  Tensor<double> strain{};  ///< time integral of D, in fixed axes [-]
  Tensor<double> stress{};  ///< Cauchy, tension positive [Pa]
};

/// A material point that is led along a path, whatever its law: what the driver calls, once per trial.
class PathPoint {
 public:
  /// What the law answers to a trial.
  struct Answer {
    Tensor<double> stress;  ///< Cauchy, tension positive [Pa]
    double unsolved;        ///< `Response::unsolved`; not 0: the step must not be taken
  };

  virtual ~PathPoint() = default;

  [[nodiscard]] virtual std::string_view law() const noexcept = 0;
  /// Names and units of the law's memory.
  [[nodiscard]] virtual std::span<const StateColumn> state_columns() const noexcept = 0;
  /// The law's memory, a number per column.
  [[nodiscard]] virtual std::vector<double> state() const = 0;
  /// The law's answer to a step from the present memory; changes nothing.
  [[nodiscard]] virtual Answer answer(const Deformation<double>& deformation, double dt) const noexcept = 0;
  /// Takes that step: the memory is then that of its end.
  virtual void remember(const Deformation<double>& deformation, double dt) noexcept = 0;
  /// Of the point as it is.
  [[nodiscard]] virtual Stiffness<double> stiffness(
      const Deformation<double>& deformation) const noexcept = 0;
  /// I [-], Eq. (R12), at the present pressure; NaN for a law without grains or a point without pressure.
  [[nodiscard]] virtual double inertial_number(const Deformation<double>& deformation) const noexcept = 0;
  /// C [-], Eq. (R15); NaN for a law that has none.
  [[nodiscard]] virtual double stability_number(const Deformation<double>& deformation) const noexcept = 0;

  PathState now;  ///< what a path begins with, and what it has come to

 protected:
  PathPoint(const PathPoint&) = default;
  PathPoint(PathPoint&&) = default;
  PathPoint& operator=(const PathPoint&) = default;
  PathPoint& operator=(PathPoint&&) = default;
  explicit PathPoint(double density) : now{0, density, {}, {}} {}
};

/// A point of one law, at rest at first. Its inputs stay the same along the path.
template <DescribedLaw Law>
class PathPointOf final : public PathPoint {
 public:
  using Input = typename Law::template Input<double>;
  using State = typename Law::template State<double>;

  /// @param density at the start [kg/m^3]  @param input what the law reads: grain size, ..
  /// @throws InputError naming law, parameter or column, value and bound, if one is out of its bound.
  PathPointOf(const Law& law, double density, const Input& input = {},
              const State& state = initial_state<Law>())
      : PathPoint{density}, law_{law}, input_{input}, state_{state} {
    validate(law);
    validate_input<Law>(input);
    now.stress = answer({Tensor<double>{}, density}, 0).stress;
  }

  [[nodiscard]] std::string_view law() const noexcept override { return Law::name; }
  [[nodiscard]] std::span<const StateColumn> state_columns() const noexcept override { return Law::states; }

  [[nodiscard]] std::vector<double> state() const override {
    if constexpr (Law::states.empty()) {
      return {};
    } else {
      const auto numbers = std::bit_cast<std::array<double, Law::states.size()>>(state_);
      return {numbers.begin(), numbers.end()};
    }
  }

  [[nodiscard]] Answer answer(const Deformation<double>& deformation, double dt) const noexcept override {
    const auto response = law_.update(deformation, input_, state_, dt);
    return {response.stress, response.unsolved};
  }

  void remember(const Deformation<double>& deformation, double dt) noexcept override {
    state_ = law_.update(deformation, input_, state_, dt).state;
  }

  [[nodiscard]] Stiffness<double> stiffness(const Deformation<double>& deformation) const noexcept override {
    return law_.stiffness(deformation, input_, state_);
  }

  [[nodiscard]] double inertial_number(const Deformation<double>& deformation) const noexcept override {
    if constexpr (requires { law_.grain_density, input_.grain_size; }) {
      const double p = mean_pressure(now.stress);
      if (p > 0) {
        return rheology::inertial_number(shear_rate(deformation.velocity_gradient), input_.grain_size, p,
                                         law_.grain_density);
      }
    }
    return std::numeric_limits<double>::quiet_NaN();
  }

  [[nodiscard]] double stability_number(const Deformation<double>& deformation) const noexcept override {
    if constexpr (HasStabilityNumber<Law>) {
      return law_.stability_number(deformation, input_, state_);
    } else {
      return std::numeric_limits<double>::quiet_NaN();
    }
  }

 private:
  Law law_;
  Input input_;
  State state_;
};

/// Density at which a point at rest, with the memory that it has, bears a pressure [kg/m^3]; changes nothing.
/// @param pressure [Pa], finite and not negative
/// @throws InputError unless the pressure is that.  @throws RunError naming the law if it has no such
/// density.
[[nodiscard]] double density_at_pressure(const PathPoint& point, double pressure);

}  // namespace scree::rheology
