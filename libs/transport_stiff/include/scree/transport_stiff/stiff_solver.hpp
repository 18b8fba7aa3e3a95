#pragma once

#include <scree/transport/fluxes/kurganov_tadmor.hpp>
#include <scree/transport/solver.hpp>
#include <scree/transport_stiff/convective_part.hpp>
#include <scree/transport_stiff/imex_integrator.hpp>
#include <scree/transport_stiff/line_preconditioner.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace scree::transport {

/// What stands in for the Jacobian in the iterations of a StiffSolver.
enum class Preconditioner {
  none,  ///< nothing: for comparison, or where diffusion is weak
  lines  ///< LinePreconditioner
};

/// What a stiff solver of N components on a kind of grid may be told.
template <class Grid, int N>
struct StiffOptions {
  std::optional<double> cfl = {};  ///< of convection [-]; 9/10 of the promised one unless given
  Threads threads = {};            ///< one unless given
  typename BoundariesOf<Grid, N>::type boundaries = {};  ///< walls unless given
  double start_time = 0;                                 ///< [s]
  ImexMethod method = ImexMethod::ssp2;
  Steps steps = Steps::longest;
  double largest_step = std::numeric_limits<double>::infinity();  ///< [s]
  std::optional<Index> max_steps = {};  ///< of one advance; see ImexOptions unless given
  double relative_tolerance = 1e-7;     ///< of implicit solves, and adaptive steps [-]
  double absolute_tolerance = 1e-9;     ///< the same [unit of u]
  ImplicitSolver solver = Gmres{};
  Preconditioner preconditioner = Preconditioner::lines;
};

/// Advances a conservation law whose diffusion or source is stiff: convection is explicit and alone decides
/// how long a step is, diffusion and source are solved for.  Eqs. (T50), (T55)
///
/// Takes the law that `Solver` takes. Sum rho V u changes by round-off and by what the source makes. With
/// ImexMethod::ssp2 and nothing stiff it is `Solver` with SspRk2; with it, bounds and total variation are not
/// promised. Rates run on threads, vector sums of the linear solver do not: the same bits for any number.
template <LatticeGrid Grid, class Law, class Reconstruct, class Flux = KurganovTadmor>
class StiffSolver {
 public:
  static constexpr int D = Grid::dimension;
  static constexpr int N = PointLawOf<Law>::num_components;
  using Options = StiffOptions<Grid, N>;
  static_assert(Diffusive<PointLawOf<Law>> || HasSource<Law, D>, "nothing is stiff here: take Solver");

  /// @throws InputError if the CFL number is not in (0, promised_cfl], or another option is out of range.
  StiffSolver(Grid grid, Law law, Reconstruct reconstruction,
              StiffOptions<Grid, PointLawOf<Law>::num_components> options = {}, Flux flux = {})
      : time_{options.start_time} {
    const double promised = promised_cfl(reconstruction);
    const double cfl = options.cfl ? *options.cfl : usual_part * promised;
    detail::require_cfl(cfl, promised);
    detail::require_start_time(time_);
    parts_ = std::make_unique<Parts>(
        Convection{{std::move(grid), {std::move(law)}, reconstruction, std::move(flux), options.boundaries},
                   promised,
                   options.threads},
        promised);
    const ImexOptions imex{.method = options.method,
                           .steps = options.steps,
                           .relative_tolerance = options.relative_tolerance,
                           .absolute_tolerance = options.absolute_tolerance,
                           .largest_step = options.largest_step,
                           .max_steps = options.max_steps,
                           .stable_part = cfl / promised,
                           .solver = options.solver};
    work_.resize(static_cast<std::size_t>(num_values()));
    integrator_.emplace(num_values(), make_problem(*parts_, options.preconditioner), imex);
  }

  /// The largest CFL number of the convective part: see `Solver::promised_cfl`.
  [[nodiscard]] static double promised_cfl(const Reconstruct& reconstruction) noexcept {
    return Solver<Grid, ConvectivePart<Law>, Reconstruct, Flux>::promised_cfl(reconstruction);
  }

  [[nodiscard]] Grid& grid() noexcept { return parts_->convection.problem().grid; }
  [[nodiscard]] Law& law() noexcept { return parts_->convection.problem().law; }
  /// Start time and all that was advanced since [s].
  [[nodiscard]] double time() const noexcept { return time_; }

  /// Advances `u` by `duration` [s].
  /// @param u num_sites x num_components, component fastest; not written at empty sites.
  /// @throws InputError for a wrong length or duration. @throws RunError if a value is not finite or an
  /// implicit solve fails; then `u` and the time are as they were.
  ImexReport advance(std::span<double> u, double duration) {
    const Parts& parts = *parts_;
    detail::require_size(u.size(), parts.convection.num_sites(), N);
    detail::require_duration(duration);
    for_each_value(u.size(), [&](std::size_t i, bool is_filled) { work_[i] = is_filled ? u[i] : 0; });
    const ImexReport report = integrator_->advance(work_, time_, duration);
    for_each_value(u.size(), [&](std::size_t i, bool is_filled) {
      if (is_filled) u[i] = work_[i];
    });
    time_ += duration;
    return report;
  }

 private:
  using Convection = SemiDiscrete<Grid, ConvectivePart<Law>, Reconstruct, Flux>;

  /// What the integrator's functions work with; it stays where it is when the solver is moved.
  struct Parts {
    Convection convection;
    double promised_cfl;
    typename Convection::Storage fields{convection.num_sites()};
    typename Convection::Storage rates{convection.num_sites()};
    std::optional<LinePreconditioner<Grid, Law>> lines = {};

    Parts(Convection made, double promised) : convection{std::move(made)}, promised_cfl{promised} {}

    [[nodiscard]] const Grid& grid() const noexcept { return convection.problem().grid; }
    [[nodiscard]] const Law& law() const noexcept { return convection.problem().law; }

    /// @return the longest stable step [s]
    double explicit_rate(double time, std::span<const double> u, std::span<double> rate) {
      fields.gather(u, convection.threads());
      const StepBounds bounds = convection(fields, rates, time);
      rates.scatter(rate, convection.threads(), [](Index /*site*/) { return true; });
      return longest_step(bounds.limit, promised_cfl);
    }
  };

  static ImexProblem make_problem(Parts& parts, Preconditioner preconditioner) {
    ImexProblem problem;
    problem.explicit_rate = [&parts](double time, std::span<const double> u, std::span<double> rate) {
      return parts.explicit_rate(time, u, rate);
    };
    problem.implicit_rate = [&parts](double time, std::span<const double> u, std::span<double> rate) {
      stiff_rate(parts.grid(), parts.law(), parts.convection.threads(), time, u, rate);
    };
    if (preconditioner == Preconditioner::none) return problem;
    parts.lines.emplace(parts.grid().lattice(), parts.convection.threads());
    problem.prepare_preconditioner = [&parts](double time, std::span<const double> u, double gamma) {
      parts.lines->prepare(parts.grid(), parts.law(), time, u, gamma);
    };
    problem.precondition = [&parts](std::span<const double> residual, std::span<double> z) {
      parts.lines->solve(residual, z);
    };
    return problem;
  }

  [[nodiscard]] Index num_values() const noexcept { return N * parts_->convection.num_sites(); }

  /// Calls body(i, whether there is anything at its site) for all values.
  template <class Body>
  void for_each_value(std::size_t num_values, Body&& body) const {
    for (std::size_t i = 0; i < num_values; ++i) {
      body(i, parts_->convection.holds(static_cast<Index>(i) / N));
    }
  }

  // [-] Of the promised CFL number: leaves room for speeds that grow within a step.
  static constexpr double usual_part = 0.9;

  std::unique_ptr<Parts> parts_;
  std::optional<ImexIntegrator> integrator_;
  std::vector<double> work_;
  double time_;
};

}  // namespace scree::transport
