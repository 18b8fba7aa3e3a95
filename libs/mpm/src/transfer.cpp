#include "instances.hpp"
#include "stencil.hpp"

#include <scree/mpm/transfer.hpp>

#include <algorithm>
#include <limits>
#include <variant>

namespace scree::mpm {

namespace {

using detail::place_of;
using detail::power;
using detail::stencil_nodes;

/// The nodes that a block's points can reach while they stay within one cell of it.
template <int D, std::size_t S>
struct TileShape {
  static constexpr Index edge = block_edge<D> + static_cast<Index>(S) + 1;
  static_assert(block_edge<D> > static_cast<Index>(S), "blocks of one colour would share nodes");
  static constexpr std::size_t num_nodes = power<D>(static_cast<std::size_t>(edge));
};

template <int D>
struct Scales {
  std::array<double, D> origin{};
  std::array<double, D> inverse_spacing{};
  explicit Scales(const CartesianGrid<D>& grid) {
    for (int axis = 0; axis < D; ++axis) {
      origin[static_cast<std::size_t>(axis)] = grid.origin()[axis];
      inverse_spacing[static_cast<std::size_t>(axis)] = 1 / grid.spacing()[axis];
    }
  }
};

/// Weights of one point's stencil: nodal weights, and their derivatives along each axis [1/m].
template <int D, class ShapeType>
struct Stencil {
  static constexpr std::size_t S = ShapeType::support;
  Index first_in_tile = 0;
  std::array<std::array<double, S>, D> weight;
  std::array<std::array<double, S>, D> gradient;
  std::array<double, D> second_moment;  // [m^2]
};

template <class ShapeType, bool has_affine, int D, int V>
[[nodiscard]] inline Stencil<D, ShapeType> stencil_of(const Particles<D, V>& particles, Index p,
                                                      const Indices<D>& tile_first, const Scales<D>& scales,
                                                      Index edge) noexcept {
  Stencil<D, ShapeType> stencil;
  Index stride = 1;
  for (std::size_t axis = 0; axis < D; ++axis) {
    const auto place = place_of(particles.position.component(static_cast<int>(axis))[p], scales.origin[axis],
                                scales.inverse_spacing[axis], ShapeType::shift);
    stencil.first_in_tile += (place.base - tile_first[axis]) * stride;
    stride *= edge;
    stencil.weight[axis] = ShapeType::weights(place.xi);
    stencil.gradient[axis] = has_affine ? ShapeType::affine(place.xi) : ShapeType::gradients(place.xi);
    for (double& g : stencil.gradient[axis]) g *= scales.inverse_spacing[axis];
    stencil.second_moment[axis] =
        ShapeType::second_moment(place.xi) / (scales.inverse_spacing[axis] * scales.inverse_spacing[axis]);
  }
  return stencil;
}

template <int D, int V, Shape ShapeType, TransferRule Rule>
class TransferBy final : public Transfer<D, V> {
 public:
  explicit TransferBy(Rule rule) : rule_{rule} {}

  [[nodiscard]] NodeRecord record() const noexcept override { return layout; }
  [[nodiscard]] double stencil_shift() const noexcept override { return ShapeType::shift; }

  void scatter(const Particles<D, V>& particles, const ParticleBlock<D>& block, Nodes<D>& nodes,
               double dt) const noexcept override {
    alignas(64) std::array<double, Tile::num_nodes * record_size> tile{};
    const Scales<D> scales{nodes.grid()};
    const Indices<D> first = tile_first(block);
    for (Index p = block.begin; p < block.end; ++p) {
      scatter_point(particles, p,
                    stencil_of<ShapeType, Rule::has_affine>(particles, p, first, scales, Tile::edge), dt,
                    tile.data());
    }
    for_each_row(nodes, first, [&](double* row, std::size_t in_tile) {
      for (std::size_t i = 0; i < record_size; ++i) row[i] += tile[in_tile + i];
    });
  }

  [[nodiscard]] BlockMotion gather(Particles<D, V>& particles, const ParticleBlock<D>& block,
                                   const Nodes<D>& nodes, double dt) const noexcept override {
    alignas(64) std::array<double, Tile::num_nodes * record_size> tile{};
    const Scales<D> scales{nodes.grid()};
    const Indices<D> first = tile_first(block);
    for_each_row(nodes, first, [&](const double* row, std::size_t in_tile) {
      for (std::size_t i = 0; i < record_size; ++i) tile[in_tile + i] = row[i];
    });
    const Reach reach{nodes.grid(), scales, block};
    BlockMotion motion;
    for (Index p = block.begin; p < block.end; ++p) {
      gather_point(particles, p,
                   stencil_of<ShapeType, Rule::has_affine>(particles, p, first, scales, Tile::edge), dt,
                   tile.data());
      double rate = 0;
      bool is_inside = true;
      for (std::size_t axis = 0; axis < D; ++axis) {
        const double x = particles.position.component(static_cast<int>(axis))[p];
        is_inside = is_inside && reach.holds(x, axis);
        rate +=
            std::abs(particles.velocity.component(static_cast<int>(axis))[p]) * scales.inverse_spacing[axis];
      }
      motion.needs_sort = motion.needs_sort || !is_inside;
      motion.advection_rate = std::max(motion.advection_rate, rate);
    }
    return motion;
  }

 private:
  static constexpr std::size_t S = ShapeType::support;
  static constexpr NodeRecord layout{V, Rule::has_increment};
  static constexpr auto record_size = static_cast<std::size_t>(layout.size());
  static constexpr auto stencil_table = stencil_nodes<D, S>();
  using Tile = TileShape<D, S>;
  using StencilType = Stencil<D, ShapeType>;

  /// Where a block's points may be without leaving its tile or the mesh.
  struct Reach {
    Scales<D> scales;
    std::array<double, D> low;          // of the mesh [m]
    std::array<double, D> high;         // of the mesh [m]
    std::array<double, D> first_base;   // of stencils in the tile, in spacings
    std::array<double, D> beyond_base;  // the first one that is not

    Reach(const CartesianGrid<D>& grid, const Scales<D>& scales_, const ParticleBlock<D>& block) noexcept
        : scales{scales_} {
      low.fill(-std::numeric_limits<double>::infinity());
      high.fill(std::numeric_limits<double>::infinity());
      for (std::size_t axis = 0; axis < D; ++axis) {
        const int a = static_cast<int>(axis);
        first_base[axis] = static_cast<double>(block.first_cell[axis] - 1);
        beyond_base[axis] = static_cast<double>(block.first_cell[axis] + block_edge<D> + 1);
        if (grid.is_periodic()[axis]) continue;
        low[axis] = grid.origin()[a];
        high[axis] = grid.origin()[a] + grid.length(a);
      }
    }

    [[nodiscard]] bool holds(double x, std::size_t axis) const noexcept {
      const double along =
          detail::coordinate(x, scales.origin[axis], scales.inverse_spacing[axis], ShapeType::shift);
      return first_base[axis] <= along && along < beyond_base[axis] && low[axis] <= x && x <= high[axis];
    }
  };

  [[nodiscard]] static Indices<D> tile_first(const ParticleBlock<D>& block) noexcept {
    Indices<D> first = block.first_cell;
    for (Index& cell : first) --cell;
    return first;
  }

  /// Calls body(record of a node, place of its copy in the tile) for every node of the tile that exists.
  template <class NodesType, class Body>
  static void for_each_row(NodesType& nodes, const Indices<D>& first, Body&& body) noexcept {
    std::array<std::array<Index, static_cast<std::size_t>(Tile::edge)>, D> offset{};
    for (std::size_t axis = 0; axis < D; ++axis) {
      for (std::size_t i = 0; i < static_cast<std::size_t>(Tile::edge); ++i) {
        const Index place = nodes.place(first[axis] + static_cast<Index>(i), axis);
        offset[axis][i] = place < 0 ? -1 : place * nodes.stride(axis);
      }
    }
    constexpr auto edge = static_cast<std::size_t>(Tile::edge);
    for (std::size_t n = 0; n < Tile::num_nodes; ++n) {
      std::size_t rest = n;
      Index node = 0;
      bool exists = true;
      for (std::size_t axis = 0; axis < D; ++axis) {
        const Index along = offset[axis][rest % edge];
        exists = exists && along >= 0;
        node += along;
        rest /= edge;
      }
      if (exists) body(nodes[node], n * record_size);
    }
  }

  static void scatter_point(const Particles<D, V>& particles, Index p, const StencilType& stencil, double dt,
                            double* tile) noexcept {
    const double mass = particles.mass.component(0)[p];
    const double volume = mass / particles.density.component(0)[p];
    std::array<double, V> momentum;
    std::array<std::array<double, V>, D> slope;  // what the nodal derivative along each axis multiplies
    for (int i = 0; i < V; ++i)
      momentum[static_cast<std::size_t>(i)] = mass * particles.velocity.component(i)[p];
    for (int j = 0; j < D; ++j) {
      for (int i = 0; i < V; ++i) {
        const double force = -volume * particles.stress.component(i + V * j)[p];
        slope[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] =
            Rule::has_affine ? dt * force + stencil.second_moment[static_cast<std::size_t>(j)] * mass *
                                                particles.velocity_gradient.component(i + V * j)[p]
                             : force;
      }
    }
    for_each_node(stencil, [&](Index in_tile, double w, const std::array<double, D>& gradient) {
      double* node = tile + in_tile * static_cast<Index>(record_size);
      node[NodeRecord::mass] += w * mass;
      for (std::size_t i = 0; i < V; ++i) {
        double along = 0;
        for (std::size_t j = 0; j < D; ++j) along += gradient[j] * slope[j][i];
        if constexpr (Rule::has_increment) {
          node[NodeRecord::momentum + static_cast<int>(i)] += w * momentum[i];
          node[layout.increment() + static_cast<int>(i)] += along;
        } else {
          node[NodeRecord::momentum + static_cast<int>(i)] += w * momentum[i] + along;
        }
      }
    });
  }

  void gather_point(Particles<D, V>& particles, Index p, const StencilType& stencil, double dt,
                    const double* tile) const noexcept {
    std::array<double, V> velocity{};
    std::array<double, V> increment{};
    std::array<std::array<double, V>, D> gradient_of_velocity{};
    for_each_node(stencil, [&](Index in_tile, double w, const std::array<double, D>& gradient) {
      const double* node = tile + in_tile * static_cast<Index>(record_size);
      for (std::size_t i = 0; i < V; ++i) {
        const double v = node[NodeRecord::momentum + static_cast<int>(i)];
        velocity[i] += w * v;
        if constexpr (Rule::has_increment) increment[i] += w * node[layout.increment() + static_cast<int>(i)];
        for (std::size_t j = 0; j < D; ++j) gradient_of_velocity[j][i] += gradient[j] * v;
      }
    });
    double divergence = 0;
    for (std::size_t j = 0; j < D; ++j) {
      particles.position.component(static_cast<int>(j))[p] += dt * velocity[j];
      divergence += gradient_of_velocity[j][j];
      for (std::size_t i = 0; i < V; ++i) {
        particles.velocity_gradient.component(static_cast<int>(i + V * j))[p] = gradient_of_velocity[j][i];
      }
    }
    for (std::size_t i = 0; i < V; ++i) {
      double& v = particles.velocity.component(static_cast<int>(i))[p];
      if constexpr (Rule::has_increment) {
        v = rule_.increment_share() * (v + increment[i]) + (1 - rule_.increment_share()) * velocity[i];
      } else {
        v = velocity[i];
      }
    }
    particles.density.component(0)[p] /= 1 + dt * divergence;
  }

  /// Calls body(node in tile, weight, derivatives of the weight) for every node of a stencil.
  template <class Body>
  static void for_each_node(const StencilType& stencil, Body&& body) noexcept {
    for (const auto& at : stencil_table) {
      Index in_tile = stencil.first_in_tile;
      Index stride = 1;
      double weight = 1;
      std::array<double, D> gradient;
      gradient.fill(1);
      for (std::size_t axis = 0; axis < D; ++axis) {
        in_tile += static_cast<Index>(at[axis]) * stride;
        stride *= Tile::edge;
        weight *= stencil.weight[axis][at[axis]];
        for (std::size_t j = 0; j < D; ++j) {
          gradient[j] *= j == axis ? stencil.gradient[axis][at[axis]] : stencil.weight[axis][at[axis]];
        }
      }
      body(in_tile, weight, gradient);
    }
  }

  Rule rule_;
};

}  // namespace

template <int D, int V>
std::unique_ptr<Transfer<D, V>> make_transfer(const AnyShape& shape, const AnyTransfer& rule) {
  return std::visit(
      [](auto chosen_shape, auto chosen_rule) -> std::unique_ptr<Transfer<D, V>> {
        return std::make_unique<TransferBy<D, V, decltype(chosen_shape), decltype(chosen_rule)>>(chosen_rule);
      },
      shape, rule);
}

// NOLINTBEGIN(bugprone-macro-parentheses): D and V are template arguments
#define SCREE_INSTANCE(D, V) \
  template std::unique_ptr<Transfer<D, V>> make_transfer<D, V>(const AnyShape&, const AnyTransfer&);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE
// NOLINTEND(bugprone-macro-parentheses)

}  // namespace scree::mpm
