#pragma once

#include <scree/transport/concepts.hpp>

namespace scree::transport {

/// Barth & Jespersen's limiter: the largest factor that keeps a cell's values at its faces within those of
/// its neighbours. The sharpest that keeps bounds; its kink makes steady solvers ring.
/// @see Eq. (T33a), \cite barth1989
struct BarthJespersen {
  static constexpr std::string_view name = "barth_jespersen";
  static constexpr std::string_view summary = "the largest factor within the neighbours' values";
  static constexpr bool keeps_bounds = true;

  [[nodiscard]] double operator()(double allowed, double wanted, double /*width*/) const noexcept {
    const double ratio = allowed / wanted;  // made whether wanted or not: no branch
    return wanted > allowed ? ratio : 1.0;
  }
};
static_assert(CellLimiter<BarthJespersen>);

}  // namespace scree::transport
