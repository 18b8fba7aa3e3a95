#pragma once

#include <scree/grid.hpp>
#include <scree/rheology/nonlocal_fluidity.hpp>

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace scree::rheology {

/// What the fluidity follows, a value per cell; those of cells without material are not read.
struct FluidityFields {
  std::span<const double> friction;    ///< mu = tau/p [-], not negative
  std::span<const double> pressure;    ///< p [Pa], positive
  std::span<const double> grain_size;  ///< s_a [m], positive
};

/// The fluidity held at the low and the high end of each axis [1/s]; no value: closed, nothing spreads
/// through it.
template <int D>
using FluidityEnds = std::array<std::array<std::optional<double>, 2>, static_cast<std::size_t>(D)>;

/// The nonlocal fluidity on the cells of a grid that hold material; faces to cells without are closed, as a
/// free surface is. Second order in space; equations are symmetric, positive definite and have no positive
/// off-diagonal, and are solved directly, so that no fluidity is negative, to the last bit.
///
/// One thread, same bits always. The solver allocates in every call. Direct solves are cheap in one and two
/// dimensions; in three they are not: seconds from some 30^3 cells on.
/// @see Eqs. (R176)-(R179)
template <int D>
class FluidityGrid {
 public:
  /// @param cells of a `CartesianGrid`, num_cells in all
  /// @param is_occupied whether a cell holds material, num_cells
  /// @param ends none for a periodic axis
  /// @throws InputError naming a parameter or part that does not fit.
  FluidityGrid(const NonlocalFluidity& model, const Lattice<D>& cells, const std::vector<bool>& is_occupied,
               const FluidityEnds<D>& ends);
  FluidityGrid(const FluidityGrid&) = delete;
  FluidityGrid& operator=(const FluidityGrid&) = delete;
  FluidityGrid(FluidityGrid&&) noexcept;
  FluidityGrid& operator=(FluidityGrid&&) noexcept;
  ~FluidityGrid();

  /// The steady fluidity, Eq. (R178).
  /// @param fluidity g, num_cells [1/s]; 0 in cells without material
  /// @throws InputError naming cell and value of a field that is out of its bounds; RunError if the equations
  /// leave the fluidity open, as with mu = mu_s all over and no end held.
  void solve_steady(const FluidityFields& fields, std::span<double> fluidity);

  /// Takes the fluidity over a step of any length, Eq. (R179); first order in time.
  /// @param dt [s], positive  @param fluidity g, num_cells [1/s], not negative
  /// @throws InputError naming cell and value of a field that is out of its bounds; RunError if dt is so long
  /// that rounding leaves the fluidity open (nothing holds it, and dt/t_0 above some 1e15 (h/A s_a)^2).
  void step(const FluidityFields& fields, double dt, std::span<double> fluidity);

 private:
  struct Equations;

  void write_to(std::span<double> fluidity) const;

  NonlocalFluidity model_;
  std::vector<Index> cells_;  ///< those that hold material
  Index num_cells_;
  double volume_;  ///< of a cell [m^D]
  std::unique_ptr<Equations> equations_;
};

}  // namespace scree::rheology
