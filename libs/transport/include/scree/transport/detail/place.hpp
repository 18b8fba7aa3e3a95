#pragma once

#include <scree/lattice.hpp>
#include <scree/transport/concepts.hpp>
#include <scree/transport/detail/numbering.hpp>

#include <span>
#include <string>

namespace scree::transport::detail {

/// Numbers as people read them: "(1, 0.5)".
[[nodiscard]] std::string tuple_text(std::span<const double> numbers);

/// A position as people read it.
template <int D>
[[nodiscard]] std::string position_text(const Vector<D>& position) {
  return tuple_text({position.data(), static_cast<std::size_t>(D)});
}

/// Where a site of a lattice is: "site (1, 2), position (0.375, 0.625) m".
template <int D>
[[nodiscard]] std::string place_text(const Indices<D>& site, const Vector<D>& position);

extern template std::string place_text<1>(const Indices<1>&, const Vector<1>&);
extern template std::string place_text<2>(const Indices<2>&, const Vector<2>&);
extern template std::string place_text<3>(const Indices<3>&, const Vector<3>&);

/// Where a cell of any grid is.
template <class Grid>
[[nodiscard]] std::string place_in(const Grid& grid, Index cell) {
  if constexpr (LatticeGrid<Grid>) {
    const Indices<Grid::dimension> site =
        Numbering<Grid::dimension>{grid.count(), grid.is_periodic()}.site(cell);
    return place_text<Grid::dimension>(site, grid.position(site));
  } else {
    return "cell " + std::to_string(cell) + ", position " +
           position_text<Grid::dimension>(grid.centre(cell)) + " m";
  }
}

}  // namespace scree::transport::detail
