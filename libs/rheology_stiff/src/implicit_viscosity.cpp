#include "implicit_viscosity_checks.hpp"
#include "instances.hpp"
#include "newton_krylov.hpp"
#include "places.hpp"
#include "preconditioner.hpp"

#include <scree/rheology_stiff/implicit_viscosity.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace scree::rheology {

namespace {

constexpr const char* solver_name = "ImplicitViscosity";

using detail::at;

template <int D, int V>
std::unique_ptr<detail::Preconditioner<D, V>> make_preconditioner(ViscousPreconditioner choice,
                                                                  const ViscousOperator<D, V>& viscous) {
  const bool can_be_line = D == 1 && !viscous.grid().is_periodic()[0];
  if (choice == ViscousPreconditioner::line && !can_be_line) {
    throw InputError{std::string{solver_name} +
                     ": the line preconditioner is for one dimension that is not periodic"};
  }
  if (choice == ViscousPreconditioner::jacobi) return detail::make_jacobi<D, V>(viscous);
  if constexpr (D == 1) {
    if (can_be_line && choice != ViscousPreconditioner::multigrid) return detail::make_line<V>(viscous);
  }
  return detail::make_multigrid<D, V>(viscous);
}

}  // namespace

template <int D, int V>
class ImplicitViscosity<D, V>::Solver {
 public:
  Solver(const CartesianGrid<D>& grid, const ImplicitViscosityOptions& options)
      : options_{options},
        viscous_{grid, options.quadrature, options.threads},
        preconditioner_{make_preconditioner<D, V>(options.preconditioner, viscous_)},
        volume_(at(viscous_.num_cells()), 0.0),
        weights_(volume_.size(), 0.0),
        couplings_(volume_.size(), 0.0),
        cell_values_(volume_.size(), 0.0),
        is_fixed_(viscous_.num_values(), 0),
        before_(viscous_.num_values(), 0.0),
        now_(viscous_.num_values(), 0.0),
        change_(viscous_.num_values(), 0.0),
        diagonal_(viscous_.num_values(), 0.0),
        linear_{static_cast<Index>(viscous_.num_values()), problem(), newton_options(true), solver_name},
        nonlinear_{static_cast<Index>(viscous_.num_values()), problem(), newton_options(false), solver_name} {
  }

  ImplicitViscosityReport advance(std::span<double> velocity, const ViscousBody& body,
                                  std::span<const double> viscosity, double dt) {
    detail::require_valid_viscosity(viscosity, volume_.size());
    begin(velocity, body, dt);
    law_ = nullptr;
    for (std::size_t c = 0; c < volume_.size(); ++c) weights_[c] = dt * volume_[c] * viscosity[c];
    return finish(velocity, linear_);
  }

  ImplicitViscosityReport advance(std::span<double> velocity, const ViscousBody& body,
                                  const ViscosityLaw& viscosity, double dt) {
    begin(velocity, body, dt);
    law_ = &viscosity;
    ask_law(before_);
    return finish(velocity, nonlinear_);
  }

 private:
  [[nodiscard]] detail::NewtonOptions newton_options(bool is_linear) const noexcept {
    return {is_linear, options_.largest_newton, options_.largest_linear};
  }

  [[nodiscard]] detail::SymmetricProblem problem() {
    using Values = detail::SymmetricProblem::Values;
    return {[this](Values u, std::span<double> r) { residual(u, r); }, [this](Values u) { linearise(u); },
            [this](Values v, std::span<double> product) { jacobian_product(v, product); },
            [this](Values r, std::span<double> z) {
              if (r.data() != z.data()) std::ranges::copy(r, z.begin());
              preconditioner_->solve(z);
              products_ += preconditioner_->products();
            }};
  }

  void begin(std::span<const double> velocity, const ViscousBody& body, double dt) {
    if (velocity.size() != viscous_.num_values()) {
      throw InputError{std::string{solver_name} + ": " + std::to_string(velocity.size()) +
                       " values of velocity: must be " + std::to_string(viscous_.num_values())};
    }
    detail::require_valid({velocity, body, dt, V, volume_.size()});
    mass_ = body.mass;
    dt_ = dt;
    products_ = 0;
    const double cell_volume = viscous_.grid().spacing().prod();
    for (std::size_t c = 0; c < volume_.size(); ++c) {
      volume_[c] = cell_volume * (body.filled.empty() ? 1 : body.filled[c]);
    }
    for (std::size_t i = 0; i < is_fixed_.size(); ++i) {
      is_fixed_[i] = !body.is_held.empty() && body.is_held[i] != 0 ? 1 : 0;
    }
    std::ranges::copy(velocity, before_.begin());
    std::ranges::copy(velocity, now_.begin());
  }

  /// Solves and, if that went well, writes the velocities.
  ImplicitViscosityReport finish(std::span<double> velocity, detail::NewtonKrylov& newton) {
    double typical = 0;
    for (const double v : before_) typical = std::max(typical, std::abs(v));
    if (typical == 0 || dt_ == 0) return {};
    const double tolerance = scale(newton, typical);
    if (law_ == nullptr && preconditioner_->is_exact() && eliminate(newton, tolerance)) {
      keep_momentum();
      std::ranges::copy(now_, velocity.begin());
      return {1, 1, products_};
    }
    detail::NewtonReport report;
    try {
      report = newton.solve(now_, tolerance);
    } catch (const RunError& error) {
      throw RunError{error.what() + where(newton)};
    }
    keep_momentum();
    std::ranges::copy(now_, velocity.begin());
    products_ += static_cast<double>(report.residuals);
    return {report.newton_iterations, report.linear_iterations, products_};
  }

  /// The linear problem by the exact preconditioner alone, without KINSOL, which costs several times as much.
  /// @return whether that met the tolerance; else all is as it was
  bool eliminate(detail::NewtonKrylov& newton, double tolerance) {
    residual(now_, change_);
    linearise(now_);
    preconditioner_->solve(change_);
    for (std::size_t i = 0; i < now_.size(); ++i) now_[i] -= change_[i];
    residual(now_, change_);
    products_ += 2 + preconditioner_->products();
    const auto inverse = newton.inverse_residual();
    bool is_solved = true;
    for (std::size_t i = 0; i < now_.size(); ++i) {
      is_solved = std::abs(change_[i]) * inverse[i] <= tolerance && is_solved;  // not for NaN
    }
    if (is_solved) return true;
    std::ranges::copy(before_, now_.begin());
    return false;
  }

  /// Typical sizes: of a velocity the largest, of a residual the momentum of what moves with a node: of its
  /// mass and of what viscosity ties to it, up to the mass of the heaviest node.  Eq. (R136)
  /// @return the tolerance: the user's, or what round-off leaves of a residual if that is more
  double scale(detail::NewtonKrylov& newton, double typical) {
    const double heaviest = *std::ranges::max_element(mass_);
    viscous_.diagonal(weights_, diagonal_);
    const auto inverse_size = newton.inverse_size();
    const auto inverse_residual = newton.inverse_residual();
    double stiffest = 0;
    for (std::size_t i = 0; i < diagonal_.size(); ++i) {
      const double moved = std::min(mass_[i / V] + diagonal_[i], heaviest);
      const double size = moved > 0 ? moved : 1;
      inverse_size[i] = 1 / typical;
      inverse_residual[i] = 1 / (size * typical);
      stiffest = std::max(stiffest, diagonal_[i] / size);
    }
    constexpr double operations = CellStiffness<D, V>::size * CellStiffness<D, V>::num_corners;
    return std::max(options_.tolerance, operations * round_off * (1 + stiffest));
  }

  /// Weights of cells for a law at a velocity, and what the derivative adds.  Eq. (R134)
  /// @throws RunError if the law answers with no viscosity, or one that no step can be solved with.
  void ask_law(std::span<const double> u) {
    viscous_.products(u, u, cell_values_);
    const Index length = viscous_.grid().num_cells()[0];
    for_each_block(viscous_.num_cells() / length, options_.threads, [&](Index line) {
      for (Index cell = line * length; cell < (line + 1) * length; ++cell) {
        const std::size_t c = at(cell);
        weights_[c] = couplings_[c] = 0;
        if (volume_[c] == 0) continue;
        const double rate = std::sqrt(std::max(cell_values_[c], 0.0));
        const ViscosityAt mu = (*law_)(rate, cell);
        weights_[c] = dt_ * volume_[c] * mu.viscosity;
        couplings_[c] = rate > 0 ? dt_ * volume_[c] * mu.slope / rate : 0;
      }
    });
    for (std::size_t c = 0; c < volume_.size(); ++c) {
      const double tangent = weights_[c] + couplings_[c] * cell_values_[c];
      // Round-off of the law itself: a slope of exactly nothing.
      if (!(tangent >= -1e3 * round_off * weights_[c] && std::isfinite(weights_[c]))) refuse_law(c);
    }
  }

  [[noreturn]] void refuse_law(std::size_t cell) const {
    const double rate = std::sqrt(std::max(cell_values_[cell], 0.0));
    const ViscosityAt mu = (*law_)(rate, static_cast<Index>(cell));
    std::ostringstream text;
    text << solver_name << ": at " << rate << " 1/s the law's viscosity of cell " << cell << " is "
         << mu.viscosity << " Pa s and its slope " << mu.slope
         << " Pa s^2: must be finite, and the stress must not fall with the rate";
    throw RunError{text.str()};
  }

  void residual(std::span<const double> u, std::span<double> result) {
    if (law_ != nullptr) ask_law(u);
    viscous_.apply({}, weights_, u, result);
    for (std::size_t i = 0; i < result.size(); ++i) {
      result[i] = is_fixed_[i] != 0 ? 0 : mass_[i / V] * (u[i] - before_[i]) + result[i];
    }
  }

  void linearise(std::span<const double> u) {
    std::ranges::copy(u, now_.begin());
    if (law_ != nullptr) ask_law(u);
    preconditioner_->prepare({mass_, weights_, tangent_couplings(), now_, is_fixed_});
  }

  [[nodiscard]] std::span<const double> tangent_couplings() const noexcept {
    return law_ != nullptr ? std::span<const double>{couplings_} : std::span<const double>{};
  }

  void jacobian_product(std::span<const double> v, std::span<double> product) {
    ++products_;
    if (law_ == nullptr) {
      viscous_.apply(mass_, weights_, v, product);
    } else {
      viscous_.products(now_, v, cell_values_);
      for (std::size_t c = 0; c < cell_values_.size(); ++c) cell_values_[c] *= couplings_[c];
      viscous_.apply_tangent(mass_, weights_, cell_values_, now_, v, product);
    }
    for (std::size_t i = 0; i < product.size(); ++i) {
      if (is_fixed_[i] != 0) product[i] = 0;
    }
  }

  /// Of what the solve left of a component that is nowhere held: its sum, evenly over the mass.  Eq. (R140)
  void keep_momentum() noexcept {
    for (std::size_t component = 0; component < V; ++component) {
      double total = 0;
      double gained = 0;
      bool is_free = true;
      for (std::size_t node = 0; node < mass_.size(); ++node) {
        const std::size_t i = node * V + component;
        is_free = is_free && is_fixed_[i] == 0;
        total += mass_[node];
        gained += mass_[node] * (now_[i] - before_[i]);
      }
      if (!is_free) continue;
      for (std::size_t i = component; i < now_.size(); i += V) {
        if (mass_[i / V] + diagonal_[i] > 0) now_[i] -= gained / total;
      }
    }
  }

  /// The node that is furthest from balance, for people.
  [[nodiscard]] std::string where(detail::NewtonKrylov& newton) {
    residual(now_, diagonal_);
    const auto inverse = newton.inverse_residual();
    std::size_t worst = 0;
    for (std::size_t i = 0; i < diagonal_.size(); ++i) {
      const double here = std::abs(diagonal_[i]) * inverse[i];
      if (!(here <= std::abs(diagonal_[worst]) * inverse[worst])) worst = i;
    }
    const auto node = static_cast<Index>(worst / V);
    const Vector<D> x = viscous_.grid().nodes().position(viscous_.grid().nodes().site(node));
    std::ostringstream text;
    text << " (the step is " << dt_ << " s, furthest from balance is component " << worst % V << " of node "
         << node << " at (";
    for (int axis = 0; axis < D; ++axis) text << (axis > 0 ? ", " : "") << x[axis];
    text << ") m: off by " << std::abs(diagonal_[worst]) * inverse[worst] << " of the momentum there)";
    return text.str();
  }

  ImplicitViscosityOptions options_;
  ViscousOperator<D, V> viscous_;
  std::unique_ptr<detail::Preconditioner<D, V>> preconditioner_;
  std::vector<double> volume_;       // of the material in each cell [m^D]
  std::vector<double> weights_;      // step x viscosity x volume [Pa s^2 m^D]
  std::vector<double> couplings_;    // step x slope/rate x volume
  std::vector<double> cell_values_;  // scratch
  std::vector<std::uint8_t> is_fixed_;
  std::vector<double> before_;  // velocities at the start of the step [m/s]
  std::vector<double> now_;     // where the problem was linearised last, and the result [m/s]
  std::vector<double> change_;  // scratch
  std::vector<double> diagonal_;
  std::span<const double> mass_;
  const ViscosityLaw* law_ = nullptr;
  double dt_ = 0;
  double products_ = 0;
  detail::NewtonKrylov linear_;
  detail::NewtonKrylov nonlinear_;
};

template <int D, int V>
ImplicitViscosity<D, V>::ImplicitViscosity(const CartesianGrid<D>& grid,
                                           const ImplicitViscosityOptions& options) {
  detail::require_valid(options);
  solver_ = std::make_unique<Solver>(grid, options);
}
template <int D, int V>
ImplicitViscosity<D, V>::ImplicitViscosity(ImplicitViscosity&& other) noexcept = default;
template <int D, int V>
ImplicitViscosity<D, V>& ImplicitViscosity<D, V>::operator=(ImplicitViscosity&& other) noexcept = default;
template <int D, int V>
ImplicitViscosity<D, V>::~ImplicitViscosity() = default;

template <int D, int V>
ImplicitViscosityReport ImplicitViscosity<D, V>::advance(std::span<double> velocity, const ViscousBody& body,
                                                         std::span<const double> viscosity, double dt) {
  return solver_->advance(velocity, body, viscosity, dt);
}
template <int D, int V>
ImplicitViscosityReport ImplicitViscosity<D, V>::advance(std::span<double> velocity, const ViscousBody& body,
                                                         const ViscosityLaw& viscosity, double dt) {
  return solver_->advance(velocity, body, viscosity, dt);
}

#define SCREE_INSTANCE(D, V) template class ImplicitViscosity<D, V>;
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::rheology
