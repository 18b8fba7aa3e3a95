#pragma once

#include <scree/lattice.hpp>
#include <scree/transport/concepts.hpp>

namespace scree::transport {

/// A lattice whose sites are all there and equally full: the plain finite-volume balance.  Eq. (T2)
template <int D>
class Cartesian {
 public:
  static constexpr int dimension = D;

  // Not explicit: a lattice is a grid, and may stand where one is asked for.
  Cartesian(const Lattice<D>& lattice) : lattice_{lattice} {}

  [[nodiscard]] const Lattice<D>& lattice() const noexcept { return lattice_; }
  /// Known when compiled, so that whatever asks for it costs nothing.
  [[nodiscard]] static constexpr double density(Index /*site*/) noexcept { return 1; }

 private:
  Lattice<D> lattice_;
};
static_assert(LatticeGrid<Cartesian<2>>);

}  // namespace scree::transport
