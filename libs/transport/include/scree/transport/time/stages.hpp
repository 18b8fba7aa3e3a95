#pragma once

#include <scree/transport/concepts.hpp>

#include <span>
#include <variant>

namespace scree::transport {

/// What a solver keeps of an integrator: the weights of its stages. Any integrator of the list turns into
/// it, and one that was chosen at run time too.  Eq. (T7)
struct Stages {
  std::span<const double> kept;  ///< of u^n, in each stage [-]

  // Not explicit: an integrator may stand where stages are asked for.
  template <Integrator I>
  Stages(const I& /*integrator*/) noexcept : kept{I::kept} {}

  template <Integrator... I>
  Stages(const std::variant<I...>& chosen) noexcept
      : kept{std::visit([](const auto& integrator) { return Stages{integrator}.kept; }, chosen)} {}
};

}  // namespace scree::transport
