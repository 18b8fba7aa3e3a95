#pragma once

#include <scree/rheology_stiff/implicit_viscosity.hpp>

#include <string>

namespace scree::rheology::detail {

/// @throws InputError naming what is out of range.
void require_valid(const ImplicitViscosityOptions& options);

/// What a step is given, as checked before it.
struct StepInput {
  std::span<const double> velocity;
  const ViscousBody& body;
  double dt;
  std::size_t num_components;
  std::size_t num_cells;
};

/// @throws InputError naming the first length that does not fit, or the first node or cell whose value is out
/// of range.
void require_valid(const StepInput& input);

/// @throws InputError naming the first cell whose viscosity is out of range.
void require_valid_viscosity(std::span<const double> viscosity, std::size_t num_cells);

}  // namespace scree::rheology::detail
