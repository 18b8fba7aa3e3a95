#pragma once

#include <string>

namespace scree::rheology {

/// How viscosity is advanced over a step.
enum class ViscousMethod {
  explicit_steps,  ///< several steps of explicit Euler, each below the viscous limit
  rkl2,            ///< one super-time-step
  implicit         ///< one step of backward Euler
};

/// A method, and why.
struct ViscousChoice {
  ViscousMethod method;
  int count;           ///< of explicit steps or stages; 1 if implicit
  std::string reason;  ///< one sentence, for the user
};

/// Where a viscosity comes from.
enum class ViscosityIs {
  given,       ///< for the whole step: an implicit step is one linear solve
  of_velocity  ///< a yield stress or friction: one for each of Newton's iterations
};

/// The cheapest method for a step, from its ratio to the longest stable explicit one. Measured crossovers:
/// Eq. (R144).
/// @param step wanted [s]  @param explicit_step longest stable one of explicit Euler [s]; infinite if nothing
/// is viscous  @param dimension of space, 1 to 3
/// @throws InputError if one is out of range
[[nodiscard]] ViscousChoice choose_viscous_method(double step, double explicit_step, int dimension,
                                                  ViscosityIs viscosity = ViscosityIs::given);

}  // namespace scree::rheology
