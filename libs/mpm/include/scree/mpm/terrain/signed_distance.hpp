#pragma once

#include <scree/error.hpp>
#include <scree/tensor.hpp>

#include <cmath>
#include <concepts>
#include <functional>
#include <utility>

namespace scree::mpm {

/// A place as seen from a surface.
template <int D>
struct FromSurface {
  double
      distance;  ///< [m], positive where material may be, negative in the ground; NaN where nothing is known
  Vector<D> normal;  ///< of unit length, the way in which the distance grows
};

/// A surface that material stands on or flows along: any callable that tells how far a place is from it. It
/// is asked when a run is assembled (a bed) or once a step near the surface (a moving body), by one thread.
template <class S, int D>
concept SignedDistance = requires(const S& surface, const Vector<D>& x) {
  { surface(x) } -> std::same_as<FromSurface<D>>;
};

/// A surface of any kind.
template <int D>
using AnySurface = std::function<FromSurface<D>(const Vector<D>&)>;

/// A plane through a point: a line in two dimensions, a place in one.
template <int D>
class PlaneSurface {
 public:
  /// @param point [m]  @param normal into the material, of any length  @throws InputError if NaN or zero.
  PlaneSurface(const Vector<D>& point, const Vector<D>& normal) : point_{point}, normal_{normal} {
    const double length = normal.norm();
    require(length > 0 && std::isfinite(length), "PlaneSurface: the normal must have a direction");
    require(point.allFinite(), "PlaneSurface: the point must be finite");
    normal_ /= length;
  }

  [[nodiscard]] FromSurface<D> operator()(const Vector<D>& x) const noexcept {
    return {(x - point_).dot(normal_), normal_};
  }

 private:
  Vector<D> point_;
  Vector<D> normal_;
};

/// A ball: the ground outside of it and material inside, or the other way round.
template <int D>
class BallSurface {
 public:
  enum class Material { inside, outside };

  /// @param centre [m]  @param radius [m], positive  @throws InputError if one is not finite or not that.
  BallSurface(const Vector<D>& centre, double radius, Material material)
      : centre_{centre}, radius_{radius}, sign_{material == Material::outside ? 1.0 : -1.0} {
    require(radius > 0 && std::isfinite(radius), "BallSurface: the radius must be positive and finite");
    require(centre.allFinite(), "BallSurface: the centre must be finite");
  }

  /// At the centre, where all ways are as long, the normal is that of the last axis.
  [[nodiscard]] FromSurface<D> operator()(const Vector<D>& x) const noexcept {
    const Vector<D> arm = x - centre_;
    const double length = arm.norm();
    const Vector<D> outward = length > 0 ? Vector<D>{arm / length} : Vector<D>{Vector<D>::Unit(D - 1)};
    return {sign_ * (length - radius_), sign_ * outward};
  }

 private:
  Vector<D> centre_;
  double radius_;
  double sign_;
};

/// The surface where a function of place is zero; material is where it is positive. Distances are F/|grad F|,
/// exact to the square of the distance times the curvature.  Eq. (M60)
template <int D>
class LevelSurface {
 public:
  /// @param step over which F is differenced, by central differences [m]; a thousandth of a cell will do
  /// @throws InputError if it is not positive and finite.
  LevelSurface(std::function<double(const Vector<D>&)> function, double step)
      : function_{std::move(function)}, step_{step} {
    require(step > 0 && std::isfinite(step), "LevelSurface: the step must be positive and finite");
  }

  [[nodiscard]] FromSurface<D> operator()(const Vector<D>& x) const {
    Vector<D> gradient;
    for (int axis = 0; axis < D; ++axis) {
      const Vector<D> shift = step_ * Vector<D>::Unit(axis);
      gradient[axis] = (function_(x + shift) - function_(x - shift)) / (2 * step_);
    }
    const double slope = gradient.norm();
    if (!(slope > 0)) return {function_(x), Vector<D>::Unit(D - 1)};
    return {function_(x) / slope, gradient / slope};
  }

 private:
  std::function<double(const Vector<D>&)> function_;
  double step_;
};

static_assert(SignedDistance<PlaneSurface<2>, 2> && SignedDistance<BallSurface<3>, 3>);
static_assert(SignedDistance<LevelSurface<2>, 2> && SignedDistance<AnySurface<3>, 3>);

}  // namespace scree::mpm
