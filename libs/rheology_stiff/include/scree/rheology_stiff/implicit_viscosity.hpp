#pragma once

#include <scree/rheology_stiff/viscous_operator.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <span>

namespace scree::rheology {

/// What moves on the nodes of a grid.
struct ViscousBody {
  std::span<const double> mass;  ///< of each node [kg]; 0: nothing is there
  std::span<const std::uint8_t> is_held =
      {};  ///< num_nodes x V: keeps the velocity it has; none: all are free
  /// The share of each cell that material fills, in [0, 1]; none: all are full.
  std::span<const double> filled = {};
};

/// A viscosity and how it changes with the shear rate.
struct ViscosityAt {
  double viscosity;  ///< mu [Pa s]
  double slope = 0;  ///< d mu/d gdot [Pa s^2]; the stress must not fall with the rate: mu + slope gdot >= 0
};
/// @param shear_rate root of the mean square over the cell [1/s]
using ViscosityLaw = std::function<ViscosityAt(double shear_rate, Index cell)>;

/// What makes conjugate gradients quick.
enum class ViscousPreconditioner {
  automatic,  ///< `line` where it can be used, else `multigrid`
  jacobi,     ///< the diagonal: iterations grow as the square root of the number of cells along an axis
  line,       ///< exact, for one dimension that is not periodic
  multigrid   ///< V-cycles over coarser and coarser cells, smoothed by Chebyshev polynomials
};

/// What a solver may be told.
struct ImplicitViscosityOptions {
  Quadrature quadrature = Quadrature::gauss;
  ViscousPreconditioner preconditioner = ViscousPreconditioner::automatic;
  double tolerance = 1e-8;   ///< of the momentum balance of any node, relative to the largest velocity [-]
  int largest_newton = 100;  ///< iterations of Newton's method
  int largest_linear = 500;  ///< iterations of conjugate gradients in each of them
  Threads threads = {};
};

/// What a step took.
struct ImplicitViscosityReport {
  long newton_iterations = 0;
  long linear_iterations = 0;  ///< of conjugate gradients
  double products = 0;         ///< of the viscous operator with a velocity, those of the preconditioner too;
                               ///< those on coarser cells count as the share of their nodes [-]
};

/// Viscosity between the nodes of a grid over one step, implicit: solves
/// m (v - v*) = -dt K(v) v by backward Euler, so that no step is too long for it.
///
/// Rigid motion is untouched, kinetic energy never grows, and a component of velocity that is nowhere held
/// keeps its momentum to round-off.  @see Eqs. (R130) to (R140)
template <int D, int V = D>
class ImplicitViscosity {
 public:
  /// @throws InputError if an option is out of range or does not fit the grid.
  explicit ImplicitViscosity(const CartesianGrid<D>& grid, const ImplicitViscosityOptions& options = {});
  ImplicitViscosity(const ImplicitViscosity&) = delete;
  ImplicitViscosity& operator=(const ImplicitViscosity&) = delete;
  ImplicitViscosity(ImplicitViscosity&& other) noexcept;
  ImplicitViscosity& operator=(ImplicitViscosity&& other) noexcept;
  ~ImplicitViscosity();

  /// Advances the velocities of nodes, num_nodes x V, component fastest [m/s], over dt [s].
  /// Allocates nothing after the first call.
  /// @param viscosity of each cell [Pa s]
  /// @throws InputError for a wrong length, or a value out of range, named by its node or cell.
  /// @throws RunError if the solver does not converge, with its own word for that and the node that is
  /// furthest from balance. Then `velocity` is as it was.
  ImplicitViscosityReport advance(std::span<double> velocity, const ViscousBody& body,
                                  std::span<const double> viscosity, double dt);
  /// The same for a viscosity that depends on the velocity. The law must not throw: it is called in parallel.
  ImplicitViscosityReport advance(std::span<double> velocity, const ViscousBody& body,
                                  const ViscosityLaw& viscosity, double dt);

 private:
  class Solver;
  std::unique_ptr<Solver> solver_;
};

}  // namespace scree::rheology
