#pragma once

#include <scree/error.hpp>
#include <scree/tensor.hpp>

#include <cmath>
#include <functional>
#include <utility>

namespace scree::mpm {

/// How a body moves: it turns about a pivot, and the pivot moves. Functions of time [s] that must not throw.
template <int D>
struct RigidMotion {
  Vector<D> pivot = Vector<D>::Zero();       ///< where it is in the body's own coordinates [m]
  std::function<Vector<D>(double)> place{};  ///< of the pivot in space [m]; none: it stays
  std::function<double(double)> angle{};     ///< of the body [rad]; none: it does not turn
  Vector<3> axis = Vector<3>::Unit(2);       ///< of unit length, that it turns about; z in two dimensions
};

/// Where a body is at one instant: x = place + turn (X - pivot), with X its own coordinates.  Eq. (M66)
template <int D>
struct Pose {
  Vector<D> pivot;  ///< [m]
  Vector<D> place;  ///< [m]
  Matrix<D> turn;

  [[nodiscard]] Vector<D> in_space(const Vector<D>& body) const noexcept {
    return place + turn * (body - pivot);
  }
  [[nodiscard]] Vector<D> in_body(const Vector<D>& x) const noexcept {
    return pivot + turn.transpose() * (x - place);
  }
};

/// The turn by an angle [rad] about an axis of unit length, by Rodrigues' formula, in the first D axes.
template <int D>
[[nodiscard]] Matrix<D> turn_about(const Vector<3>& axis, double angle) noexcept {
  Matrix<3> cross = Matrix<3>::Zero();
  for (int i = 0; i < 3; ++i) {
    cross((i + 2) % 3, (i + 1) % 3) = axis[i];
    cross((i + 1) % 3, (i + 2) % 3) = -axis[i];
  }
  const Matrix<3> turn =
      Matrix<3>::Identity() + std::sin(angle) * cross + (1 - std::cos(angle)) * (cross * cross);
  return turn.template topLeftCorner<D, D>();
}

template <int D>
[[nodiscard]] Pose<D> pose_at(const RigidMotion<D>& motion, double time) {
  return {motion.pivot, motion.place ? motion.place(time) : motion.pivot,
          motion.angle ? turn_about<D>(motion.axis, motion.angle(time)) : Matrix<D>{Matrix<D>::Identity()}};
}

/// @throws InputError if the axis is not of unit length, or would turn the body out of the mesh's own axes.
template <int D>
void check(const RigidMotion<D>& motion) {
  const double rounding = 64 * round_off;
  require(std::abs(motion.axis.norm() - 1) <= rounding, "RigidMotion: the axis must be of unit length");
  require(D == 3 || !motion.angle || (D == 2 && std::abs(motion.axis[2]) >= 1 - rounding),
          "RigidMotion: in two dimensions a body turns about z, in one not at all");
  require(motion.pivot.allFinite(), "RigidMotion: the pivot must be finite");
}

/// A motion under which a body stays one of revolution round an axis of symmetry: of where its pivot goes
/// only the part along the axis is taken, at the radius that it has at the start.
/// @throws InputError if the body turns.
template <int D>
[[nodiscard]] RigidMotion<D> along_axis(RigidMotion<D> motion, double start_time) {
  require(!motion.angle, "make_rigid_body: a body that turns does not stay one of revolution");
  if (!motion.place) return motion;
  const double radius = motion.place(start_time)[0];
  motion.place = [place = std::move(motion.place), radius](double time) {
    Vector<D> kept = place(time);
    kept[0] = radius;
    return kept;
  };
  return motion;
}

}  // namespace scree::mpm
