#pragma once

#include <scree/grid.hpp>
#include <scree/instruction_set.hpp>
#include <scree/mpm/particle_blocks.hpp>
#include <scree/mpm/particles.hpp>
#include <scree/mpm/shapes.hpp>

#include <span>
#include <vector>

namespace scree::mpm {

/// How the change of carried fields on the control volumes comes back to the points.
enum class CarriedMap {
  exchange,   ///< Eq. (M22): conservative, and every point stays within [0, 1] with sum 1
  increments  ///< Eq. (M23), the source paper's eq. (11): conservative, but points leave [0, 1]
};

template <int D>
struct CarriedBlock;

/// A component of a column that is mapped to the control volumes.
struct CarriedField {
  const Column* column;
  int component;
};

/// Carried fields of the points on control volumes, the cells of the mesh or the boxes round its nodes, and
/// their change back on the points. Which it is only chooses the weights w_ip: a top hat, or those of
/// momentum with images past walls folded back.  @see Eqs. (M21)-(M23)
template <int D, int V>
class CarriedCells {
 public:
  /// @param shape of momentum, whose weights nodes have
  /// @param set what its loops are compiled for: one of instruction_sets()
  CarriedCells(const CartesianGrid<D>& grid, Sites sites, const AnyShape& shape,
               InstructionSet set = widest_instruction_set());

  [[nodiscard]] const Lattice<D>& lattice() const noexcept { return lattice_; }

  /// m_i = sum_p w_ip m_p and the mass-weighted means of `fields`.  Eq. (M21)
  /// @param blocks of the points, sorted for the shape; no point has left the reach of its block
  /// @param masses num_sites [kg]
  /// @param means num_sites x fields.size(), field fastest; zero where there is no mass
  void to_sites(const Particles<D, V>& particles, const ParticleBlocks<D>& blocks,
                std::span<const CarriedField> fields, std::span<double> masses, std::span<double> means,
                Threads threads) const;

  /// Brings the change of the fractions on the sites back to the points.
  /// @param fractions column of num_classes components, changed in place
  /// @param old_means,new_means num_sites x num_classes, class fastest: what to_sites() gave, and what became
  ///        of it with the masses held; each site's changes must sum to zero
  void to_points(const ParticleBlocks<D>& blocks, const Particles<D, V>& particles, Column& fractions,
                 std::span<const double> old_means, std::span<const double> new_means, CarriedMap map,
                 Threads threads);

 private:
  [[nodiscard]] CarriedBlock<D> opened(const Particles<D, V>& particles,
                                       const ParticleBlock<D>& block) const noexcept;

  CartesianGrid<D> grid_;
  Lattice<D> lattice_;
  AnyShape shape_;
  InstructionSet set_;
  std::vector<double> records_;  ///< of each site: loss ratios of all classes, then gain shares
};

}  // namespace scree::mpm
