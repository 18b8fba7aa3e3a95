#include "cut_shapes.hpp"
#include "instances.hpp"
#include "kernel_choice.hpp"
#include "kernels/transfer_kernels.hpp"

#include <scree/mpm/transfer.hpp>

#include <limits>
#include <variant>

namespace scree::mpm {

namespace {

template <int D, int V>
[[nodiscard]] TransferKernels<D, V> kernels_for(InstructionSet set, std::size_t shape, std::size_t rule) {
  detail::require_kernels(set, "make_transfer");
#ifdef SCREE_WIDE_KERNELS
  if (set == InstructionSet::x86_64_v4) return x86_64_v4::transfer_kernels<D, V>(shape, rule);
  if (set == InstructionSet::x86_64_v3) return x86_64_v3::transfer_kernels<D, V>(shape, rule);
#endif
  return baseline::transfer_kernels<D, V>(shape, rule);
}

/// Lays a block's points, its place and its nodes open to the kernels.
template <int D, int V>
class TransferBy final : public Transfer<D, V> {
 public:
  TransferBy(const AnyShape& shape, const AnyTransfer& rule, InstructionSet set)
      : shape_{shape}, rule_{rule}, kernels_{kernels_for<D, V>(set, shape.index(), rule.index())} {
    support_ = std::visit([](const auto& s) { return s.support; }, shape);
    shift_ = std::visit([](const auto& s) { return s.shift; }, shape);
    has_affine_ = std::visit([](const auto& r) { return r.has_affine; }, rule);
    has_affine_gradient_ = std::visit([](const auto& r) { return r.has_affine_gradient; }, rule);
    record_ = {V, std::visit([](const auto& r) { return r.has_increment; }, rule)};
  }

  [[nodiscard]] NodeRecord record() const noexcept override { return record_; }
  [[nodiscard]] double stencil_shift() const noexcept override { return shift_; }
  [[nodiscard]] Index tile_edge() const noexcept override { return tile_edge_of<D>(support_); }

  void scatter(const Particles<D, V>& particles, const ParticleBlock<D>& block, Nodes<D>& nodes,
               double dt) const noexcept override {
    kernels_.scatter(shape_, columns_of<const double>(particles, block), place_of(block, nodes.grid()),
                     tile_of(block, nodes, nodes[0]), dt);
  }

  void scatter_cut(const Particles<D, V>& particles, const ParticleBlock<D>& block, Nodes<D>& nodes,
                   const MeshEnd& end, double dt) const noexcept override {
    if (!has_affine_) return;
    std::visit([&](const auto& shape) { detail::move_to_cut(shape, particles, block, end, nodes); }, shape_);
    if (!gathers_cut()) return;
    const double time = record_.has_increment ? 1 : dt;
    const Cubic shape = std::get<Cubic>(shape_);
    detail::push_by_cut(shape, particles, block, end, time, nodes);
  }

  [[nodiscard]] BlockMotion gather(Particles<D, V>& particles, const ParticleBlock<D>& block,
                                   const Nodes<D>& nodes, double dt) const noexcept override {
    return kernels_.gather(shape_, rule_, columns_of<double>(particles, block), place_of(block, nodes.grid()),
                           tile_of(block, nodes, nodes[0]), dt);
  }

  [[nodiscard]] bool gathers_cut() const noexcept override {
    return has_affine_gradient_ && std::holds_alternative<Cubic>(shape_);
  }

  void gather_cut(Particles<D, V>& particles, const ParticleBlock<D>& block, const Nodes<D>& nodes,
                  const MeshEnd& end, const double* position, double dt) const noexcept override {
    if (!gathers_cut()) return;
    detail::mend_gradients(std::get<Cubic>(shape_), position, nodes, end, dt, block, particles);
  }

 private:
  template <class Value, class AnyParticles>
  [[nodiscard]] static PointColumns<D, V, Value> columns_of(AnyParticles& particles,
                                                            const ParticleBlock<D>& block) noexcept {
    return {.position = particles.position.component(0),
            .velocity = particles.velocity.component(0),
            .velocity_gradient = particles.velocity_gradient.component(0),
            .stress = particles.stress.component(0),
            .mass = particles.mass.component(0),
            .density = particles.density.component(0),
            .stride = particles.size(),
            .begin = block.begin,
            .end = block.end};
  }

  [[nodiscard]] BlockPlace<D> place_of(const ParticleBlock<D>& block,
                                       const CartesianGrid<D>& grid) const noexcept {
    BlockPlace<D> place;
    place.low.fill(-std::numeric_limits<double>::infinity());
    place.high.fill(std::numeric_limits<double>::infinity());
    for (std::size_t axis = 0; axis < D; ++axis) {
      const int a = static_cast<int>(axis);
      place.origin[axis] = grid.origin()[a];
      place.inverse_spacing[axis] = 1 / grid.spacing()[a];
      place.first_base[axis] = static_cast<double>(block.first_cell[axis] - block_skin<D>);
      place.beyond_base[axis] = static_cast<double>(block.first_cell[axis] + block_edge<D> + block_skin<D>);
      if (grid.is_periodic()[axis]) continue;
      place.low[axis] = grid.origin()[a];
      place.high[axis] = grid.origin()[a] + grid.length(a);
    }
    return place;
  }

  template <class Value>
  [[nodiscard]] TileNodes<D, Value> tile_of(const ParticleBlock<D>& block, const Nodes<D>& nodes,
                                            Value* values) const noexcept {
    TileNodes<D, Value> tile;
    tile.values = values;
    const auto edge = static_cast<std::size_t>(tile_edge());
    for (std::size_t axis = 0; axis < D; ++axis) {
      const Index first = block.first_cell[axis] - block_skin<D>;
      for (std::size_t i = 0; i < edge; ++i) {
        const Index place = nodes.place(first + static_cast<Index>(i), axis);
        tile.offset[axis][i] = place < 0 ? -1 : place * nodes.stride(axis) * record_.size();
      }
    }
    return tile;
  }

  AnyShape shape_;
  AnyTransfer rule_;
  TransferKernels<D, V> kernels_;
  std::size_t support_;
  double shift_;
  bool has_affine_;
  bool has_affine_gradient_;
  NodeRecord record_;
};

}  // namespace

template <int D, int V>
std::unique_ptr<Transfer<D, V>> make_transfer(const AnyShape& shape, const AnyTransfer& rule,
                                              InstructionSet set) {
  return std::make_unique<TransferBy<D, V>>(shape, rule, set);
}

// NOLINTBEGIN(bugprone-macro-parentheses): D and V are template arguments
#define SCREE_INSTANCE(D, V)                                                                        \
  template std::unique_ptr<Transfer<D, V>> make_transfer<D, V>(const AnyShape&, const AnyTransfer&, \
                                                               InstructionSet);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE
// NOLINTEND(bugprone-macro-parentheses)

}  // namespace scree::mpm
