#pragma once

#include <scree/mpm/boundaries/carried_input.hpp>
#include <scree/mpm/boundaries/contact.hpp>
#include <scree/mpm/boundaries/rigid_motion.hpp>
#include <scree/mpm/boundary.hpp>
#include <scree/mpm/terrain/bed_nodes.hpp>

#include <algorithm>
#include <memory>
#include <utility>

namespace scree::mpm {

/// A rigid body that moves as it is told, through the mesh. At each step it holds the nodes that feel its
/// pressure, as a bed does, relative to its own velocity there.  @see Eqs. (M61), (M63), (M66)-(M68)
template <int D, WallLaw Law>
class RigidBody final : public Boundary<D> {
 public:
  using Input = typename Law::template Input<double>;

  /// @param shape in the body's own coordinates; must not throw
  /// @param start_time of the run [s], from which the steps count
  RigidBody(const Contact<Law>& contact, const Input& input, const CarriedInput<Law>& carried,
            AnySurface<D> shape, RigidMotion<D> motion, double start_time, Symmetry symmetry)
      : contact_{contact},
        input_{input},
        carried_{carried},
        shape_{std::move(shape)},
        motion_{std::move(motion)},
        time_{start_time},
        symmetry_{symmetry} {}

  void fold(Nodes<D>& /*nodes*/) const noexcept override {}

  void hold(Nodes<D>& nodes, double dt) const noexcept override {
    const NodeRecord layout = nodes.record();
    const Pose<D> now = pose_at(motion_, time_);
    const Pose<D> next = pose_at(motion_, time_ + dt);
    const double volume = nodes.grid().spacing().prod();
    for (Index n = 0; n < nodes.num_nodes(); ++n) {
      double* node = nodes[n];
      if (!(node[NodeRecord::mass] > 0)) continue;
      const Vector<D> x = node_position(nodes, n);
      const Vector<D> body = now.in_body(x);
      const FromSurface<D> seen = shape_(body);
      const Vector<D> normal = now.turn * seen.normal;
      const double reach = normal.cwiseAbs().dot(nodes.grid().spacing());
      if (!(seen.distance < reach)) continue;
      const double depth = depth_at(symmetry_, nodes.grid(), Vector<D>{x - seen.distance * normal});
      const double share = std::max(depth * (1 - std::abs(seen.distance) / reach), least_area_share);
      const double mobility = dt * share * volume / reach / node[NodeRecord::mass];
      const Vector<3> wall = embedded((next.in_space(body) - x) / dt);
      change_velocity(layout, node, [&](const Vector<3>& velocity) -> Vector<3> {
        return wall + contact_.left(velocity - wall, embedded(normal), mobility,
                                    carried_.at(input_, nodes.means(n)));
      });
    }
  }

  void reflect(Nodes<D>& /*nodes*/) const noexcept override {}
  void advance(double dt) noexcept override { time_ += dt; }

 private:
  [[nodiscard]] static Vector<3> embedded(const Vector<D>& v) noexcept {
    Vector<3> result = Vector<3>::Zero();
    result.template head<D>() = v;
    return result;
  }

  Contact<Law> contact_;
  Input input_;
  CarriedInput<Law> carried_;
  AnySurface<D> shape_;
  RigidMotion<D> motion_;
  double time_;
  Symmetry symmetry_;
};

/// @param input what the law reads, but for what is `carried` by the points there
/// @throws InputError if the motion's axis is none, or the body does not stay one of revolution round an axis
///   of symmetry.
template <int D, WallLaw Law>
[[nodiscard]] std::unique_ptr<Boundary<D>> make_rigid_body(
    const Contact<Law>& contact, AnySurface<D> shape, RigidMotion<D> motion, double start_time = 0,
    const typename Law::template Input<double>& input = {}, Symmetry symmetry = Symmetry::plane,
    const CarriedInput<Law>& carried = {}) {
  check(motion);
  require(symmetry == Symmetry::plane || !motion.angle,
          "make_rigid_body: a body that turns does not stay one of revolution");
  return std::make_unique<RigidBody<D, Law>>(contact, input, carried, std::move(shape), std::move(motion),
                                             start_time, symmetry);
}

}  // namespace scree::mpm
