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

  [[nodiscard]] Index num_means() const noexcept override { return carried_.num_means(); }

  void mark_read(const Nodes<D>& nodes, std::span<std::uint8_t> is_read) const noexcept override {
    const Pose<D> now = pose_at(motion_, time_);
    for (Index batch = 0; batch < nodes.num_batches(); ++batch) {
      for (const NodeRun& run : nodes.batch(batch)) {
        for (Index n = run.begin; n < run.end; ++n) {
          if (seen_from(nodes, now, node_position(nodes, n)).is_held)
            is_read[static_cast<std::size_t>(n)] = 1;
        }
      }
    }
  }

  [[nodiscard]] bool reads_elsewhere() const noexcept override { return motion_.place || motion_.angle; }

  void fold(Nodes<D>& /*nodes*/, const double* /*gravity*/, double /*dt*/) const noexcept override {}

  void hold(Nodes<D>& nodes, double dt) const noexcept override {
    const NodeRecord layout = nodes.record();
    const Pose<D> now = pose_at(motion_, time_);
    const Pose<D> next = pose_at(motion_, time_ + dt);
    const double volume = nodes.grid().spacing().prod();
    for (Index n = 0; n < nodes.num_nodes(); ++n) {
      double* node = nodes[n];
      if (!(node[NodeRecord::mass] > 0)) continue;
      const Vector<D> x = node_position(nodes, n);
      const Seen seen = seen_from(nodes, now, x);
      if (!seen.is_held) continue;
      const double depth = depth_at(symmetry_, nodes.grid(), Vector<D>{x - seen.distance * seen.normal});
      const double share = std::max(depth * (1 - std::abs(seen.distance) / seen.reach), least_area_share);
      const double mobility = dt * share * volume / seen.reach / node[NodeRecord::mass];
      const Vector<3> wall = embedded((next.in_space(now.in_body(x)) - x) / dt);
      change_velocity(layout, node, [&](const Vector<3>& velocity) -> Vector<3> {
        return wall + contact_.left(velocity - wall, embedded(seen.normal), mobility,
                                    carried_.at(input_, nodes.means(n)));
      });
    }
  }

  void reflect(Nodes<D>& /*nodes*/) const noexcept override {}
  void advance(double dt) noexcept override { time_ += dt; }

 private:
  /// The body as seen from a node.
  struct Seen {
    double distance;   ///< [m]
    Vector<D> normal;  ///< in space
    double reach;      ///< of the node's hat function along the normal [m]
    bool is_held;      ///< whether the node feels its pressure  @see Eq. (M61)
  };
  [[nodiscard]] Seen seen_from(const Nodes<D>& nodes, const Pose<D>& now, const Vector<D>& x) const noexcept {
    const FromSurface<D> seen = shape_(now.in_body(x));
    const Vector<D> normal = now.turn * seen.normal;
    const double reach = normal.cwiseAbs().dot(nodes.grid().spacing());
    return {seen.distance, normal, reach, seen.distance < reach};
  }

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
/// @param motion round an axis of symmetry only along it: what it says of the radius after the start is not
/// used
/// @throws InputError if the motion's axis is none, or the body turns round an axis of symmetry.
template <int D, WallLaw Law>
[[nodiscard]] std::unique_ptr<Boundary<D>> make_rigid_body(
    const Contact<Law>& contact, AnySurface<D> shape, RigidMotion<D> motion, double start_time = 0,
    const typename Law::template Input<double>& input = {}, Symmetry symmetry = Symmetry::plane,
    const CarriedInput<Law>& carried = {}) {
  check(motion);
  if (symmetry == Symmetry::axial) motion = along_axis(std::move(motion), start_time);
  return std::make_unique<RigidBody<D, Law>>(contact, input, carried, std::move(shape), std::move(motion),
                                             start_time, symmetry);
}

}  // namespace scree::mpm
