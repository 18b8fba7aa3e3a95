#pragma once

#include "scree/assemble/filling.hpp"
#include "scree/scene/scene.hpp"

#include <scree/mpm/inflow.hpp>
#include <scree/mpm/outflow.hpp>

#include <string>
#include <vector>

namespace scree::app {

/// What passes into a run and out of it, beside points that leave its mesh.
template <int D, int V>
struct Streams {
  std::vector<mpm::Inflow<D, V>> inflows;
  std::vector<mpm::Outflow<D>> outflows;
  std::vector<mpm::Passed<V>> taken;  ///< by each outflow

  /// Points that have passed either way.
  [[nodiscard]] Index num_passed() const;
};

/// A stream of the scene's law.
template <int D, int V>
[[nodiscard]] mpm::Stream<D, V> stream_of(const Scene& scene, const InflowScene& inflow);

/// The outflows of a scene, nothing taken.
template <int D>
[[nodiscard]] std::vector<mpm::Outflow<D>> outflows_of(const Scene& scene, const CartesianGrid<D>& grid);

/// Height of the surface straight above a place: of the stream in whose box it lies, or of the material. A
/// stream that runs along the normal falls freely: nothing is above it. [m]
template <int D>
[[nodiscard]] double surface_above(const Scene& scene, const Filling<D>& filling, const Vector<D>& x);

/// @throws InputError if material begins in the box of a stream.
template <int D, int V>
void require_clear_of_streams(const Scene& scene, const mpm::Particles<D, V>& material);

/// What to say of streams whose points lie too far apart; nothing if none does.
[[nodiscard]] std::string too_thin_streams(const Scene& scene);

/// What to say of a stream that is blocked: of the points in the first cell before its box being denser than
/// they enter, by more than waves and weight make them; else nothing. Looks at every point, as the sorting of
/// a layer that has entered does.
/// @param time for the text [s]  @see Eqs. (M188), (M189)
template <int D, int V>
[[nodiscard]] std::string blocked_warning(const Scene& scene, std::size_t number,
                                          const mpm::Particles<D, V>& layer, const mpm::State<D, V>& state,
                                          const mpm::Stages<D, V>& stages, double time);

}  // namespace scree::app
