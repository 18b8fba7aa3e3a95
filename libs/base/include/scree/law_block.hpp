#pragma once

#include <scree/constitutive_law.hpp>
#include <scree/instruction_set.hpp>
#include <scree/pack_size.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace scree {

/// What a pack reads of a component that a run in fewer dimensions lacks.
inline constexpr std::array<double, pack_size> pack_of_zeros{};

/// One number of each point of a block: the number of point p is `values[step * p]`. A step of 0 is for
/// `pack_of_zeros`, which every pack reads alike.
struct BlockColumn {
  const double* values = pack_of_zeros.data();
  Index step = 0;  ///< 0 or 1
};

/// The points of one block under one law, a column of one number per point for everything.
template <class Law>
struct LawBlock {
  Index num_points = 0;                                    ///< whole packs
  std::array<BlockColumn, 9> velocity_gradient{};          ///< L, row by row [1/s]
  const double* density = nullptr;                         ///< at the end of the step [kg/m^3]
  std::array<const double*, Law::inputs.size()> inputs{};  ///< in the order of the law's `inputs`
  std::array<double*, Law::states.size()> states{};  ///< in the order of the law's `states`: old in, new out
  std::array<double*, 9> stress{};                   ///< row by row [Pa]; null: not wanted
};

/// The places in a tensor, row by row, of xz, yz, zx and zy.
inline constexpr std::array<std::size_t, 4> out_of_plane{2, 5, 6, 7};

/// Whether nothing flows along z, nor changes along it but by stretching: the gradients that a run in a
/// plane, of axial symmetry or in a column lacks read `pack_of_zeros`.
template <class Law>
[[nodiscard]] bool is_plane(const LawBlock<Law>& block) noexcept {
  return std::ranges::all_of(out_of_plane,
                             [&](std::size_t i) { return block.velocity_gradient[i].step == 0; });
}

/// The largest speed, viscosity and rate met in a block: what bounds the next step; and what its law could
/// not solve.
struct BlockStiffness {
  double wave_speed = 0;           ///< [m/s]
  double kinematic_viscosity = 0;  ///< viscosity over density [m^2/s]
  double relaxation_rate = 0;      ///< [1/s]
  double unsolved = 0;             ///< worst of its points, `Response::unsolved` [-]
  Index unsolved_point = -1;       ///< the first as bad, counted from the block's first; -1: none

  /// Takes over what is larger in another.
  void widen(const BlockStiffness& other) noexcept {
    wave_speed = std::max(wave_speed, other.wave_speed);
    kinematic_viscosity = std::max(kinematic_viscosity, other.kinematic_viscosity);
    relaxation_rate = std::max(relaxation_rate, other.relaxation_rate);
    const bool comes_first = other.unsolved == unsolved && other.unsolved_point < unsolved_point;
    if (other.unsolved > unsolved || (unsolved > 0 && comes_first)) {
      unsolved = other.unsolved;
      unsolved_point = other.unsolved_point;
    }
  }
};

/// Brings the points of a block up to date over a step of dt [s]: writes their states and stresses.
template <class Law>
using BlockKernel = BlockStiffness (*)(const Law& law, const LawBlock<Law>& block, double dt) noexcept;

}  // namespace scree
