#pragma once

#include <scree/mpm/leaving.hpp>
#include <scree/mpm/step.hpp>

#include <array>
#include <limits>
#include <memory>

namespace scree::mpm {

/// A stream of material that enters a mesh through a box: in the box it moves as one at a given velocity,
/// whatever lies before it, as if pushed. Behind the box there is no mesh, or an end of it without a wall.
template <int D, int V = D>
struct Stream {
  Vector<D> low = Vector<D>::Zero();   ///< lowest corner of the box [m]
  Vector<D> high = Vector<D>::Zero();  ///< highest [m]
  /// Along one axis of the mesh; components without an axis are free. [m/s]
  std::array<double, V> velocity{};
  double density = 0;                                     ///< [kg/m^3]
  Indices<D> per_cell{};                                  ///< points along each axis of a cell
  double start = 0;                                       ///< time at which it begins to enter [s]
  double stop = std::numeric_limits<double>::infinity();  ///< time at which it ends [s]
};

/// The axis that a stream runs along.
/// @throws InputError if the velocity is not finite, or does not lie along one axis of the mesh.
template <int D, int V>
[[nodiscard]] int axis_of(const Stream<D, V>& stream);

/// Points in the whole box of a stream, moving.
/// @throws InputError if the box reaches out of the mesh, is less than two cells long or does not begin and
/// end on nodes along the stream, that axis is periodic, the box holds no point, the density is not positive
/// or the stream does not begin before it ends.
template <int D, int V>
[[nodiscard]] Particles<D, V> fill_box(const Stream<D, V>& stream, const CartesianGrid<D>& grid);

/// The points that enter together: those of the box next to its face upstream, one spacing thick. Columns
/// that the points of a run have beside their own are then to be added, in the same order, with what new
/// points carry in them.  @throws InputError as fill_box() does.
template <int D, int V>
[[nodiscard]] Particles<D, V> first_layer(const Stream<D, V>& stream, const CartesianGrid<D>& grid);

/// Counts the layers of a stream that have entered. One enters when the stream has moved by its thickness, so
/// that they form a lattice, and their mass is rho v A t within that of one layer.  @see Eq. (M160)
template <int D, int V>
class Inflow {
 public:
  /// @param layer from first_layer(), with all columns of the run
  Inflow(const Stream<D, V>& stream, const CartesianGrid<D>& grid, Particles<D, V> layer);

  [[nodiscard]] const Particles<D, V>& layer() const noexcept { return layer_; }
  /// Number of layers that have entered.
  [[nodiscard]] Index num_layers() const noexcept { return num_layers_; }
  /// What has entered in them; the sums of carried columns are left out.
  [[nodiscard]] Passed<V> entered() const;
  /// Goes on where that many layers have entered, for instance by a checkpoint.
  void resume(Index num_layers) noexcept { num_layers_ = num_layers; }

  /// Layers that have come in whole by `time` [s] and have not been counted.
  [[nodiscard]] Index num_due(double time) const noexcept;
  /// Counts the next layer.  @returns its points, where they are by `time` [s]
  [[nodiscard]] Particles<D, V> next(double time);

  /// The longest step that misses no layer while the mesh is empty [s]: one layer's; or up to the first
  /// one's; infinite when the stream has ended.
  [[nodiscard]] double longest_step(double time) const noexcept;

 private:
  Stream<D, V> stream_;
  int axis_;
  double thickness_;  // of a layer [m]
  double upstream_;   // place of the face that they enter by [m]
  Particles<D, V> layer_;
  Index num_layers_ = 0;
};

/// Between steps: adds to a run the layers that have entered by `time` [s], numbers their points, and sorts.
/// @returns whether there were any.
/// @throws InputError as append() does, and if what laws read of a layer is out of their range: then none has
/// been added.
template <int D, int V>
bool take_in(State<D, V>& state, const Stages<D, V>& stages, Inflow<D, V>& inflow, double time,
             Threads threads);

/// Holds at the velocity of a stream, while it enters, the nodes that its box's points reach, those beyond
/// the face downstream left out: a boundary that comes last, and before steps are taken.
/// @param reach of the shape function from a point [spacings]: 1 + its stencil_shift
/// @throws InputError as fill_box() does.
template <int D, int V>
[[nodiscard]] std::unique_ptr<Boundary<D>> make_inflow_hold(const Stream<D, V>& stream,
                                                            const CartesianGrid<D>& grid, double reach);

}  // namespace scree::mpm
