#pragma once

#include <scree/transport/concepts.hpp>

namespace scree::transport {

/// First order: the cell's value at both faces. The most robust, and the most diffusive.  Eq. (T4)
struct PiecewiseConstant {
  static constexpr std::string_view name = "piecewise_constant";
  static constexpr std::string_view summary = "first order: the cell's own value at its faces";

  template <class State>
  [[nodiscard]] Edges<State> operator()(const State& /*below*/, const State& here,
                                        const State& /*above*/) const noexcept {
    return {here, here};
  }

  [[nodiscard]] double promised_cfl() const noexcept { return 1; }
};
static_assert(Reconstruction<PiecewiseConstant, 1>);

}  // namespace scree::transport
