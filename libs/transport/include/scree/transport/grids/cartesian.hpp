#pragma once

#include <scree/lattice.hpp>
#include <scree/transport/concepts.hpp>

namespace scree::transport {

/// A lattice whose sites are all there and equally full: the plain finite-volume balance.  Eq. (T2)
template <int D>
class Cartesian {
 public:
  static constexpr int dimension = D;
  static constexpr bool is_full = true;  ///< density 1 everywhere, known when compiled
  static constexpr bool has_equal_spacing = true;

  // Not explicit: a lattice is a grid, and may stand where one is asked for.
  Cartesian(const Lattice<D>& lattice) : lattice_{lattice} {}

  [[nodiscard]] const Lattice<D>& lattice() const noexcept { return lattice_; }
  [[nodiscard]] const Indices<D>& count() const noexcept { return lattice_.count; }
  [[nodiscard]] const std::array<bool, D>& is_periodic() const noexcept { return lattice_.is_periodic; }
  [[nodiscard]] Vector<D> position(const Indices<D>& site) const noexcept { return lattice_.position(site); }

  /// Control volume of a site [m^D].
  [[nodiscard]] double volume(const Indices<D>& site) const noexcept { return lattice_.volume(site); }
  /// Extent of the control volumes with this coordinate [m].
  [[nodiscard]] double width(int axis, Index coordinate) const noexcept {
    Indices<D> site{};
    site[static_cast<std::size_t>(axis)] = coordinate;
    return lattice_.width(site, axis);
  }
  /// Distance to the site below [m].
  [[nodiscard]] double distance_below(int axis, Index /*coordinate*/) const noexcept {
    return lattice_.spacing[axis];
  }
  /// Where the boundary lies at an end of an axis [m].
  [[nodiscard]] double end(int axis, End end) const noexcept {
    const double margin = lattice_.sites == Sites::cells ? lattice_.spacing[axis] / 2 : 0.0;
    if (end == End::low) return lattice_.first[axis] - margin;
    const auto last = static_cast<double>(lattice_.count[static_cast<std::size_t>(axis)] - 1);
    return lattice_.first[axis] + last * lattice_.spacing[axis] + margin;
  }
  /// Known when compiled, so that whatever asks for it costs nothing.
  [[nodiscard]] static constexpr double density(Index /*site*/) noexcept { return 1; }

 private:
  Lattice<D> lattice_;
};
static_assert(LatticeGrid<Cartesian<2>>);

}  // namespace scree::transport
