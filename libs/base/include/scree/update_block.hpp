#pragma once

#include <scree/law_block.hpp>
#include <scree/pack_columns.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

namespace scree {

namespace detail {

/// The largest numbers met in each lane.
template <class Real>
struct LaneMaxima {
  Real wave_speed{};
  Real kinematic_viscosity{};
  Real relaxation_rate{};
  Real unsolved{};
  Real unsolved_pack{-1.0};  ///< first point of the pack that was so

  void widen(const Stiffness<Real>& here, const Real& density, const Real& here_unsolved, Index p) noexcept {
    const auto larger = [](const Real& a, const Real& b) { return select(a > b, a, b); };
    wave_speed = larger(here.wave_speed, wave_speed);
    kinematic_viscosity = larger(here.viscosity / density, kinematic_viscosity);
    relaxation_rate = larger(here.relaxation_rate, relaxation_rate);
    unsolved_pack = select(here_unsolved > unsolved, Real(static_cast<double>(p)), unsolved_pack);
    unsolved = larger(here_unsolved, unsolved);
  }

  /// Those of all lanes.
  [[nodiscard]] BlockStiffness reduced() const noexcept {
    const auto lanes = [](const Real& number) {
      std::array<double, num_lanes<Real>> result;
      std::memcpy(result.data(), static_cast<const void*>(&number), sizeof(Real));
      return result;
    };
    BlockStiffness result;
    for (std::size_t lane = 0; lane < num_lanes<Real>; ++lane) {
      result.widen({lanes(wave_speed)[lane], lanes(kinematic_viscosity)[lane], lanes(relaxation_rate)[lane],
                    lanes(unsolved)[lane],
                    static_cast<Index>(lanes(unsolved_pack)[lane]) + static_cast<Index>(lane)});
    }
    return result;
  }
};

/// The points of a block by packs of Real, whose memory of State is in `states`.
template <class Real, class State, class Law, std::size_t N>
class PacksOfBlock {
 public:
  using Input = typename Law::template Input<Real>;
  using Columns = std::array<double*, N>;

  /// Both have to outlive it.
  PacksOfBlock(const LawBlock<Law>& block, const Columns& states) noexcept : block_{block}, states_{states} {}

  [[nodiscard]] Deformation<Real> deformation(Index p) const noexcept {
    Deformation<Real> deformation{};
    for (std::size_t i = 0; i < 9; ++i) {
      const BlockColumn& column = block_.velocity_gradient[i];
      deformation.velocity_gradient.components[i] = loaded<Real>(column.values + column.step * p);
    }
    deformation.density = loaded<Real>(block_.density + p);
    return deformation;
  }
  [[nodiscard]] Input input(Index p) const noexcept { return loaded_from<Input, Real>(block_.inputs, p); }
  [[nodiscard]] State state(Index p) const noexcept { return loaded_from<State, Real>(states_, p); }
  void store_state(const State& state, Index p) const noexcept { store_members<Real>(state, states_, p); }
  void store(const Response<Real, State>& response, Index p) const noexcept {
    store_state(response.state, p);
    store_members<Real>(response.stress.components, block_.stress, p);
  }

 private:
  const LawBlock<Law>& block_;
  const Columns& states_;
};

/// Brings the points of a block up to date, whose memory is in `states`.
template <class Real, class State, class Law, std::size_t N>
BlockStiffness update_points(const Law& law, const LawBlock<Law>& block, const std::array<double*, N>& states,
                             double dt) noexcept {
  static_assert(pack_size % num_lanes<Real> == 0);
  constexpr auto lanes = static_cast<Index>(num_lanes<Real>);
  const Law parameters = law;  // a copy, which the columns that are written cannot be part of
  const PacksOfBlock<Real, State, Law, N> packs{block, states};
  LaneMaxima<Real> worst;
  constexpr Index together = PredictsAndCorrects<Law> ? 8 * pack_size : lanes;  // memory stays in cache
  for (Index first = 0; first < block.num_points; first += together) {
    const Index last = std::min(first + together, block.num_points);
    if constexpr (PredictsAndCorrects<Law>) {
      for (Index p = first; p < last; p += lanes) {
        packs.store_state(parameters.predict(packs.deformation(p), packs.state(p), Real(dt)), p);
      }
    }
    for (Index p = first; p < last; p += lanes) {
      const Deformation<Real> deformation = packs.deformation(p);
      const auto input = packs.input(p);
      const auto response = [&] {
        if constexpr (PredictsAndCorrects<Law>) {
          return parameters.correct(deformation, input, packs.state(p), Real(dt));
        } else {
          return parameters.update(deformation, input, packs.state(p), Real(dt));
        }
      }();
      worst.widen(parameters.stiffness(deformation, input, response.state), deformation.density,
                  response.unsolved, p);
      packs.store(response, p);
    }
  }
  return worst.reduced();
}

}  // namespace detail

/// Brings the points of a block up to date, as many at once as Real has lanes: what a kernel is made of, and
/// what runs a law that has none. Each point gets the bits that it would get alone, for one instruction set
/// and contraction of products and sums. A block in plane flow is run by the law's form for that, if it has
/// one.
/// @tparam Real double, or a pack of up to `pack_size` doubles (std::experimental::simd)
/// @tparam PlaneReal the same for a law's form for plane flow
/// @see BlockKernel
template <class Real, class Law, class PlaneReal = Real>
[[gnu::flatten]] BlockStiffness update_block(const Law& law, const LawBlock<Law>& block, double dt) noexcept {
  if constexpr (HasPlaneForm<Law>) {
    if (is_plane(block)) {
      using State = typename Law::template PlaneState<PlaneReal>;
      std::array<double*, Law::plane_states.size()> states;
      const auto column = [&](std::size_t i) { return block.states[i]; };
      std::ranges::transform(Law::plane_states, states.begin(), column);
      return detail::update_points<PlaneReal, State>(law, block, states, dt);
    }
  }
  using State = typename Law::template State<Real>;
  return detail::update_points<Real, State>(law, block, block.states, dt);
}

/// A law's own kernel for an instruction set: `block_kernel(law, set)`, a function beside the law that
/// argument-dependent lookup finds. A law that has none, or a null one, runs point by point.
template <class Law>
[[nodiscard]] BlockKernel<Law> kernel_of(const Law& law, InstructionSet set) noexcept {
  if constexpr (requires { block_kernel(law, set); }) {
    if (const BlockKernel<Law> kernel = block_kernel(law, set)) return kernel;
  }
  return &update_block<double, Law>;
}

}  // namespace scree
