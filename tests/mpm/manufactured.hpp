#pragma once

#include "neo_hookean.hpp"

#include <scree/mpm/boundary.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace scree::mpm {

/// E = 10 MPa, Poisson's ratio 0.3, 1000 kg/m^3, as in \cite wallstedt2008.
inline constexpr NeoHookean rubber{.lambda = 0.3e7 / (1.3 * 0.4), .mu = 1e7 / (2 * 1.3), .density = 1000};
inline constexpr double swing_rate =
    100 * std::numbers::pi;  ///< omega of both motions [rad/s]: pi sqrt(E/rho)

/// F of a law's state as a matrix, and back.
[[nodiscard]] inline NeoHookean::State<double> state_of(const Matrix<2>& F) {
  return {F(0, 0), F(0, 1), F(1, 0), F(1, 1)};
}

/// A motion of the unit square with a body force that makes it exact: compression and stretching along both
/// axes, u_d = A sin(2 pi X_d) cos(omega t + phase_d). Nothing moves on the square's sides.  Eqs. (M81),
/// (M82)
struct AxisAlignedSwing {
  double amplitude;  ///< A [m]

  [[nodiscard]] Vector<2> place(const Vector<2>& X, double t) const {
    return X + Vector<2>{displacement(X[0], t, 0), displacement(X[1], t, 1)};
  }
  [[nodiscard]] Matrix<2> gradient(const Vector<2>& X, double t) const {
    Matrix<2> F = Matrix<2>::Zero();
    for (int d = 0; d < 2; ++d) F(d, d) = stretch(X[d], t, d);
    return F;
  }
  /// Body force at a place x of the deformed square [m/s^2].
  [[nodiscard]] Vector<2> force(const Vector<2>& x, double t) const {
    const Vector<2> X{origin(x[0], t, 0), origin(x[1], t, 1)};
    const Matrix<2> F = gradient(X, t);
    const double log_J = std::log(F(0, 0) * F(1, 1));
    Vector<2> b;
    for (int d = 0; d < 2; ++d) {
      const double u = displacement(X[d], t, d);
      const double slope = -wave_number * wave_number * u;  // of F_dd along X_d
      const double squared = F(d, d) * F(d, d);
      const double divergence = slope * (rubber.lambda * (1 - log_J) + rubber.mu * (1 + squared)) / squared;
      b[d] = -swing_rate * swing_rate * u - divergence / rubber.density;
    }
    return b;
  }

 private:
  static constexpr double wave_number = 2 * std::numbers::pi;  // [1/m]

  [[nodiscard]] static double phase(double t, int axis) {
    return swing_rate * t + (axis == 0 ? 0 : std::numbers::pi);
  }
  [[nodiscard]] double displacement(double X, double t, int axis) const {
    return amplitude * std::sin(wave_number * X) * std::cos(phase(t, axis));
  }
  [[nodiscard]] double stretch(double X, double t, int axis) const {
    return 1 + wave_number * amplitude * std::cos(wave_number * X) * std::cos(phase(t, axis));
  }
  /// Where the material at x came from. Newton's steps at least halve the distance while 2 pi A < 1/3.
  [[nodiscard]] double origin(double x, double t, int axis) const {
    double X = x;
    for (int i = 0; i < 60; ++i) {
      const double change = (X + displacement(X, t, axis) - x) / stretch(X, t, axis);
      X -= change;
      if (std::abs(change) < 4 * round_off) break;
    }
    return X;
  }
};

/// A ring about (1/2, 1/2) that turns to and fro by the angle A sin(omega t) (1 - s^2)^4, s = -1 at its inner
/// and 1 at its outer radius; all else rests. The volume is kept, the shear is not small.  Eqs. (M83), (M84)
struct TurningRing {
  double amplitude;  ///< A [rad]
  double hoop_sign =
      -1;  ///< of sigma_theta theta / r in the radial balance: +1 is the mistake that is easily made

  [[nodiscard]] Vector<2> place(const Vector<2>& X, double t) const {
    const Vector<2> from_centre = X - centre();
    const Vector<2> turned = rotation(turn(from_centre.norm()).angle * swing(t)) * from_centre;
    return centre() + turned;
  }
  [[nodiscard]] Matrix<2> gradient(const Vector<2>& X, double t) const {
    const Vector<2> from_centre = X - centre();
    const double R = from_centre.norm();
    const Turn of_ring = turn(R);
    Matrix<2> sheared = Matrix<2>::Identity();
    if (R > 0) sheared += swing(t) * of_ring.slope / R * across(from_centre) * from_centre.transpose();
    return rotation(of_ring.angle * swing(t)) * sheared;
  }
  [[nodiscard]] Vector<2> force(const Vector<2>& x, double t) const {
    const Vector<2> from_centre = x - centre();
    const double r = from_centre.norm();
    const Turn of_ring = turn(r);
    if (of_ring.angle == 0) return Vector<2>::Zero();
    const double rate = amplitude * swing_rate * std::cos(swing_rate * t) * of_ring.angle;
    const double acceleration = -swing_rate * swing_rate * swing(t) * of_ring.angle;
    const double shear = swing(t) * r * of_ring.slope;
    const double shear_slope = swing(t) * (of_ring.slope + r * of_ring.curvature);
    const double wave_speed_squared = rubber.mu / rubber.density;
    const double radial = -r * rate * rate - hoop_sign * wave_speed_squared * shear * shear / r;
    const double around = r * acceleration - wave_speed_squared * (shear_slope + 2 * shear / r);
    return (radial * from_centre + around * across(from_centre)) / r;
  }

 private:
  /// Angle over the amplitude [-] and its derivatives along the radius [1/m], [1/m^2].
  struct Turn {
    double angle;
    double slope;
    double curvature;
  };
  static constexpr double inner = 0.1;   // [m]
  static constexpr double outer = 0.45;  // [m]

  [[nodiscard]] static Vector<2> centre() { return Vector<2>::Constant(0.5); }
  [[nodiscard]] static Vector<2> across(const Vector<2>& v) { return {-v[1], v[0]}; }
  [[nodiscard]] static Matrix<2> rotation(double angle) {
    Matrix<2> Q;
    Q << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    return Q;
  }
  [[nodiscard]] double swing(double t) const { return amplitude * std::sin(swing_rate * t); }
  [[nodiscard]] static Turn turn(double R) {
    const double half = (outer - inner) / 2;
    const double s = (R - (inner + outer) / 2) / half;
    if (std::abs(s) >= 1) return {0, 0, 0};
    const double u = 1 - s * s;
    return {std::pow(u, 4), -8 * s * std::pow(u, 3) / half,
            (48 * s * s * u * u - 8 * std::pow(u, 3)) / (half * half)};
  }
};

/// A body force that depends on place and time, given to the nodes between momentum and walls: what users
/// push before their walls into `Stages::boundaries`.
template <class Motion>
class BodyForceOf final : public Boundary<2> {
 public:
  /// @param time at which a step begins [s]; followed while it changes
  BodyForceOf(const Motion& motion, const double& time) : motion_{motion}, time_{&time} {}

  void fold(Nodes<2>& /*nodes*/, const double* /*gravity*/, double /*dt*/) const noexcept override {}
  void hold(Nodes<2>& nodes, double dt) const noexcept override {
    const NodeRecord layout = nodes.record();
    for (Index j = 0; j < nodes.count(1); ++j) {
      for (Index i = 0; i < nodes.count(0); ++i) {
        double* node = nodes[i * nodes.stride(0) + j * nodes.stride(1)];
        if (!(node[NodeRecord::mass] > 0)) continue;
        const auto& grid = nodes.grid();
        const Vector<2> x{grid.origin()[0] + grid.spacing()[0] * static_cast<double>(i + nodes.first(0)),
                          grid.origin()[1] + grid.spacing()[1] * static_cast<double>(j + nodes.first(1))};
        const Vector<2> change = dt * motion_.force(x, *time_);
        for (int d = 0; d < 2; ++d) {
          node[NodeRecord::momentum + d] += change[d];
          if (layout.has_increment) node[layout.increment() + d] += change[d];
        }
      }
    }
  }
  void hold_mapped(Nodes<2>& /*nodes*/, double /*dt*/) const noexcept override {}
  void reflect(Nodes<2>& /*nodes*/) const noexcept override {}

 private:
  Motion motion_;
  const double* time_;
};

}  // namespace scree::mpm
