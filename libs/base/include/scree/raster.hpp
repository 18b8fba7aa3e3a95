#pragma once

#include <scree/tensor.hpp>

#include <vector>

namespace scree {

/// A map: one number for each square cell of a region, of its centre.
struct Raster {
  Index num_columns = 0;  ///< from west to east, along x
  Index num_rows = 0;     ///< from south to north, along y
  Vector<2> first{0, 0};  ///< centre of the cell in the south-west [m]
  double cell_size = 0;   ///< [m]
  /// num_columns x num_rows, column fastest, from the south-west on; NaN where nothing is known.
  std::vector<double> values{};
};

}  // namespace scree
