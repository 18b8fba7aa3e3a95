#pragma once

#include <scree/mpm/boundaries.hpp>
#include <scree/mpm/cell_means.hpp>
#include <scree/mpm/leaving.hpp>
#include <scree/mpm/node_means.hpp>
#include <scree/mpm/node_solve.hpp>
#include <scree/mpm/order.hpp>
#include <scree/mpm/point_term.hpp>
#include <scree/mpm/read_nodes.hpp>
#include <scree/mpm/stress_update.hpp>
#include <scree/mpm/time_step.hpp>
#include <scree/mpm/transfer.hpp>
#include <scree/mpm/xpic.hpp>

#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace scree::mpm {

/// What a step is made of, chosen when a run is assembled.
template <int D, int V>
struct Stages {
  std::unique_ptr<StressUpdate<D, V>> stress;
  std::unique_ptr<Transfer<D, V>> transfer;
  std::vector<std::unique_ptr<Boundary<D>>> boundaries;
  std::unique_ptr<NodeMeans<D, V>> node_means;  ///< what boundaries read of points; none: they read nothing
  std::unique_ptr<PointTerm<D, V>> point_term;  ///< such as those of axisymmetric flow; none: there are none
  std::unique_ptr<NodeSolve<D, V>> node_solve;  ///< what is implicit; none: nothing is
  std::array<double, V> gravity{};              ///< [m/s^2]
  /// A node lighter than this share of the heaviest point takes no part: its acceleration would be a small
  /// force over next to no mass.  [-], Eqs. (M20), (M195), (M196)
  double mass_floor = 1e-10;
  Leaving leaving = Leaving::stop;  ///< what happens to points that leave the mesh
  Order order = Order::usl;         ///< when stress is brought up to date; usl alone takes no extra pass
  Averaging averaging;              ///< over cells, against locking and noise; takes a pass over the points
  Xpic<D, V> xpic;                  ///< filter of velocities; takes a pass for each order
  std::optional<std::size_t> balanced;  ///< column whose sums are kept of what is absorbed, by its index
};

/// Wall-clock time spent in each phase of the steps so far [s].
struct PhaseSeconds {
  double scatter = 0;  ///< stress and points to nodes
  double nodes = 0;    ///< momentum and walls
  double gather = 0;   ///< nodes to points
  double sort = 0;
};

/// What one block reports of a step.
struct BlockResult {
  BlockStiffness stiffness;
  BlockMotion motion;
};

/// Copies of columns from before a pass that changes them, and what passes hand on within a step; empty where
/// no stage asks for them.
struct Spare {
  std::vector<double> position;           ///< also where gradients beside walls are mended [m]
  std::vector<double> velocity;           ///< [m/s]
  std::vector<double> velocity_gradient;  ///< [1/s]
  std::vector<double> density;            ///< [kg/m^3]
  std::vector<double> smooth;             ///< velocity, smoothed once [m/s]
  std::vector<double> filtered;           ///< change of velocity by the filter [m/s]
  std::vector<Extremes> extremes;         ///< of what boundaries read of points
};

/// Everything that changes in a step.
template <int D, int V>
struct State {
  State(Particles<D, V> points, Nodes<D> empty_nodes)
      : particles{std::move(points)}, nodes{std::move(empty_nodes)} {}

  Particles<D, V> particles;
  Nodes<D> nodes;
  ParticleBlocks<D> blocks;
  std::vector<BlockResult> block_results;  ///< one per block
  Rates rates;                             ///< of the last step; what the next one is bounded by
  bool needs_sort = true;                  ///< a point has left the reach of its block
  double mass_floor = 0;                   ///< [kg]
  double next_id = 0;                      ///< of a point that is added
  Passed<V> absorbed;                      ///< what has left the mesh so far
  Spare spare;
  CellMeans<D> means;
  ReadNodes<D> read;  ///< where boundaries read points
  PhaseSeconds seconds;
};

/// Sorts new points, and finds what bounds the first step.
/// @throws RunError naming a point outside the mesh.
/// @throws InputError if there is no point, the filter of velocities does not suit the transfer, or a
/// boundary reads more of the points than the stages bring to the nodes.
template <int D, int V>
[[nodiscard]] State<D, V> start(Particles<D, V> particles, const CartesianGrid<D>& grid,
                                const Stages<D, V>& stages, Threads threads);

/// Goes on with points and blocks that were sorted before, for instance read from a checkpoint: colours the
/// blocks, and puts the nodes around them to use.
/// @throws InputError if a boundary reads more of the points than the stages bring to the nodes.
template <int D, int V>
void resume(State<D, V>& state, const Stages<D, V>& stages);

/// Advances all points by dt [s]: stress first, with the velocity gradient of the last step, then momentum,
/// then positions; in another order if told.  @see Eqs. (M1)-(M13), (M126)-(M132), the algorithm of
/// docs/equations/mpm.md
/// @throws RunError naming a point that has left the mesh (if that is to stop the run), has no finite
/// position, no volume left, or whose law was not solved; in that last case no point has moved, unless stress
/// comes last.
template <int D, int V>
void step(State<D, V>& state, const Stages<D, V>& stages, double dt, Threads threads);

/// v = momentum / mass + dt (force / mass + gravity), dt [s], gravity [m/s^2], at nodes over `mass_floor`
/// [kg], zero at the others; increments alike where the record has them.  Eq. (M11)
template <int D>
void advance_momentum(Nodes<D>& nodes, const double* gravity, double dt, double mass_floor, Threads threads);

}  // namespace scree::mpm
