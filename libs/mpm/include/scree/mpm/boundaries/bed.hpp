#pragma once

#include <scree/mpm/boundaries/carried_input.hpp>
#include <scree/mpm/boundaries/contact.hpp>
#include <scree/mpm/boundary.hpp>
#include <scree/mpm/terrain/bed_nodes.hpp>

#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace scree::mpm {

/// Ground inside the mesh. It holds the nodes that feel its pressure, whichever way it cuts the mesh: what
/// approaches it is stopped, what slides is slowed by a law of friction.  @see Eqs. (M61)-(M63)
template <int D, WallLaw Law>
class Bed final : public Boundary<D> {
 public:
  using Input = typename Law::template Input<double>;

  /// @param inputs of the law, one for each node, but for what is `carried` by the points there
  Bed(const Contact<Law>& contact, std::vector<BedNode> nodes, std::vector<Input> inputs,
      const CarriedInput<Law>& carried)
      : contact_{contact}, nodes_{std::move(nodes)}, inputs_{std::move(inputs)}, carried_{carried} {}

  [[nodiscard]] Index num_means() const noexcept override { return carried_.num_means(); }

  void mark_read(const Nodes<D>& /*nodes*/, std::span<std::uint8_t> is_read) const noexcept override {
    for (const BedNode& bed : nodes_) is_read[static_cast<std::size_t>(bed.node)] = 1;
  }

  void fold(Nodes<D>& /*nodes*/, const double* /*gravity*/, double /*dt*/) const noexcept override {}

  void hold(Nodes<D>& nodes, double dt) const noexcept override {
    const NodeRecord layout = nodes.record();
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      const BedNode& bed = nodes_[n];
      double* node = nodes[bed.node];
      change_velocity(layout, node, [&](const Vector<3>& velocity) {
        return contact_.left(velocity, bed.normal, dt * bed.area / node[NodeRecord::mass],
                             carried_.at(inputs_[n], nodes.means(bed.node)));
      });
    }
  }

  void reflect(Nodes<D>& /*nodes*/) const noexcept override {}

 private:
  Contact<Law> contact_;
  std::vector<BedNode> nodes_;
  std::vector<Input> inputs_;
  CarriedInput<Law> carried_;
};

/// A bed of any shape.
/// @param input_at what the law reads at a place of the bed, for instance from a raster, but for what is
/// `carried` by the points there
/// @throws InputError if the surface reaches no node of the mesh.
template <int D, WallLaw Law>
[[nodiscard]] std::unique_ptr<Boundary<D>> make_bed(
    const Contact<Law>& contact,
    const std::function<typename Law::template Input<double>(const Vector<D>&)>& input_at,
    const CartesianGrid<D>& grid, const AnySurface<D>& surface, Symmetry symmetry = Symmetry::plane,
    const CarriedInput<Law>& carried = {}) {
  std::vector<BedNode> held = bed_nodes(grid, surface, symmetry);
  const Nodes<D> nodes{grid, {.num_velocities = 1, .has_increment = false}};
  std::vector<typename Law::template Input<double>> inputs;
  inputs.reserve(held.size());
  for (const BedNode& node : held) inputs.push_back(input_at(node_position(nodes, node.node)));
  return std::make_unique<Bed<D, Law>>(contact, std::move(held), std::move(inputs), carried);
}

/// A bed of any shape under a law that reads nothing.
template <int D, WallLaw Law>
[[nodiscard]] std::unique_ptr<Boundary<D>> make_bed(const Contact<Law>& contact, const CartesianGrid<D>& grid,
                                                    const AnySurface<D>& surface,
                                                    Symmetry symmetry = Symmetry::plane) {
  using Input = typename Law::template Input<double>;
  return make_bed<D, Law>(
      contact, [](const Vector<D>&) { return Input{}; }, grid, surface, symmetry);
}

}  // namespace scree::mpm
