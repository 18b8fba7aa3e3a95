#pragma once

#include <scree/grid.hpp>
#include <scree/mpm/particle_blocks.hpp>
#include <scree/mpm/particles.hpp>

#include <vector>

namespace scree::mpm {

/// What is the same all over a cell of the mesh, against locking and noise.
struct Averaging {
  bool volume_change = false;  ///< laws see the mean rate of volume of a cell.  Eq. (M131)
  bool pressure = false;       ///< forces are those of the mean pressure of a cell.  Eq. (M132)

  [[nodiscard]] bool is_on() const noexcept { return volume_change || pressure; }
};

/// Means over the points of each cell, weighted by their volumes.
template <int D>
class CellMeans {
 public:
  /// Takes the memory that means over the cells of a mesh need, if there are more points than before.
  void prepare(const CartesianGrid<D>& grid, Index num_points) {
    cells_.resize(static_cast<std::size_t>(grid.cells().num_sites()));
    cell_of_.resize(static_cast<std::size_t>(num_points));
  }

  /// Replaces the trace over the D axes of a tensor column by its mean over each cell, the rest stays. Points
  /// must be within the reach of their blocks.
  /// @param tensor velocity gradient or stress, component i + V j
  template <int V>
  void average_trace(const Particles<D, V>& particles, Column& tensor, const ParticleBlocks<D>& blocks,
                     const CartesianGrid<D>& grid, Threads threads);

 private:
  struct Sum {
    double volume = 0;  ///< [m^D]
    double trace = 0;   ///< times volume
  };
  std::vector<Sum> cells_;
  std::vector<Index> cell_of_;  ///< of each point
};

}  // namespace scree::mpm
