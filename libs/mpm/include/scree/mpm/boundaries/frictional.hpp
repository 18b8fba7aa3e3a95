#pragma once

#include <scree/error.hpp>
#include <scree/mpm/boundaries/carried_input.hpp>
#include <scree/mpm/boundaries/hold.hpp>
#include <scree/mpm/boundaries/wall_lines.hpp>
#include <scree/mpm/boundary.hpp>
#include <scree/symmetry.hpp>
#include <scree/wall_law.hpp>

#include <memory>

namespace scree::mpm {

/// A plane wall on an end of the mesh that resists sliding by a friction law. Shape functions that reach past
/// it are cut off so that they still add up to one and to linear fields: what an image node would get goes to
/// the wall, twice, less once to the node inside. Material may slide, shear and leave without pulling on it.
/// @see Eqs. (M26) to (M28), and \ref law_walls for the laws
template <int D, WallLaw Law>
class FrictionalWall final : public Boundary<D> {
 public:
  using Input = typename Law::template Input<double>;

  FrictionalWall(const Law& law, const Input& input, Hold hold, int axis, Side side, Symmetry symmetry,
                 const CarriedInput<Law>& carried)
      : law_{law},
        input_{input},
        carried_{carried},
        hold_{hold},
        axis_{static_cast<std::size_t>(axis)},
        side_{side},
        symmetry_{symmetry} {}

  [[nodiscard]] std::optional<MeshEnd> cuts_shapes() const noexcept override {
    return MeshEnd{static_cast<int>(axis_), side_};
  }

  [[nodiscard]] Index num_means() const noexcept override { return carried_.num_means(); }

  void mark_read(const Nodes<D>& nodes, std::span<std::uint8_t> is_read) const noexcept override {
    const Index inward = side_ == Side::low ? nodes.stride(axis_) : -nodes.stride(axis_);
    for (const Index image : nodes.images(axis_, side_)) {
      is_read[static_cast<std::size_t>(image + inward)] = 1;
    }
  }

  /// Weight too: it is that of the mass that a node then has.
  void fold(Nodes<D>& nodes, const double* /*gravity*/, double /*dt*/) const noexcept override {
    const int num_values = nodes.record().size();
    for_each_wall_line(nodes, axis_, side_,
                       [&](double* image, double* wall, double* inside, Index /*image*/) {
                         for (int i = 0; i < num_values; ++i) {
                           wall[i] += 2 * image[i];
                           inside[i] -= image[i];
                         }
                       });
  }

  void hold(Nodes<D>& nodes, double dt) const noexcept override {
    const NodeRecord layout = nodes.record();
    const Index inward = side_ == Side::low ? nodes.stride(axis_) : -nodes.stride(axis_);
    for_each_wall_line(nodes, axis_, side_, [&](double*, double* wall, double*, Index image) {
      Vector<3> velocity = Vector<3>::Zero();
      for (int i = 0; i < layout.num_velocities; ++i) velocity[i] = wall[NodeRecord::momentum + i];
      const double mobility = dt * area_of(nodes, image) / wall[NodeRecord::mass];
      const Vector<3> left =
          left_by_wall(velocity, mobility, carried_.at(input_, nodes.means(image + inward)));
      for (int i = 0; i < layout.num_velocities; ++i) {
        if (layout.has_increment) wall[layout.increment() + i] += left[i] - velocity[i];
        wall[NodeRecord::momentum + i] = left[i];
      }
    });
  }

  void reflect(Nodes<D>& nodes) const noexcept override {
    const NodeRecord layout = nodes.record();
    const int end = layout.size();
    for_each_wall_line(nodes, axis_, side_,
                       [&](double* image, const double* wall, const double* inside, Index) {
                         for (int i = NodeRecord::momentum; i < end; ++i) image[i] = 2 * wall[i] - inside[i];
                       });
  }

 private:
  [[nodiscard]] Vector<3> left_by_wall(const Vector<3>& velocity, double mobility,
                                       const Input& input) const noexcept {
    const int axis = static_cast<int>(axis_);
    const Vector<3> normal = (side_ == Side::low ? 1 : -1) * Vector<3>::Unit(axis);
    Vector<3> left = slide<3>(law_, velocity, normal, mobility, input);
    if (hold_ == Hold::pushes_and_pulls) left[axis] = 0;
    return left;
  }

  /// The part of the wall that a node stands for, the integral of its hat function over it [m^(D-1)], given
  /// the image beyond it.  Eqs. (M28), (M176)
  [[nodiscard]] double area_of(const Nodes<D>& nodes, Index image) const noexcept {
    const bool is_ring = symmetry_ == Symmetry::axial && axis_ == 0;
    double area = is_ring ? nodes.grid().length(0) : 1;
    for (std::size_t other = 0; other < D; ++other) {
      if (other == axis_) continue;
      const Index node = image / nodes.stride(other) % nodes.count(other) + nodes.first(other);
      area *= hat_integral(symmetry_, nodes.grid(), static_cast<int>(other), node);
    }
    return area;
  }

  Law law_;
  Input input_;
  CarriedInput<Law> carried_;
  Hold hold_;
  std::size_t axis_;
  Side side_;
  Symmetry symmetry_;
};

/// A wall with friction, on an end of an axis.
/// @param input what the law reads, the same all over the wall, but for what is `carried` by the points there
/// @throws InputError if there is no such axis, or it would be an axis of symmetry, where no wall is.
template <int D, WallLaw Law>
[[nodiscard]] std::unique_ptr<Boundary<D>> make_frictional_wall(
    const Law& law, const typename Law::template Input<double>& input, Hold hold, int axis, Side side,
    Symmetry symmetry = Symmetry::plane, const CarriedInput<Law>& carried = {}) {
  require(0 <= axis && axis < D, "make_frictional_wall: no such axis");
  require(symmetry == Symmetry::plane || axis > 0 || side == Side::high,
          "make_frictional_wall: the low end of axis 0 is the axis of symmetry, which slips");
  return std::make_unique<FrictionalWall<D, Law>>(law, input, hold, axis, side, symmetry, carried);
}

}  // namespace scree::mpm
