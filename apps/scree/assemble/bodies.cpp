#include "scree/assemble/ground.hpp"
#include "scree/assemble/with_contact.hpp"
#include "scree/scene/vector_of.hpp"

#include <scree/mpm/boundaries/rigid_body.hpp>
#include <scree/mpm/terrain/triangle_surface.hpp>

#include <algorithm>

namespace scree::app {

namespace {

template <int D>
[[nodiscard]] mpm::AnySurface<D> made(const BallScene& ball) {
  using Ball = mpm::BallSurface<D>;
  return Ball{vector_of<D>(ball.centre), ball.radius,
              ball.is_hollow ? Ball::Material::inside : Ball::Material::outside};
}

template <int D>
[[nodiscard]] mpm::AnySurface<D> made(const PlaneScene& plane) {
  return mpm::PlaneSurface<D>{vector_of<D>(plane.point), vector_of<D>(plane.normal)};
}

template <int D>
[[nodiscard]] mpm::AnySurface<D> made(const TriangleMesh& triangles) {
  if constexpr (D != 3) {
    throw InputError{"[[bodies]] surface: triangles are for meshes of 3 dimensions"};
  } else {
    return mpm::TriangleSurface{triangles};
  }
}

/// A place between those of two times, or the one at the end that is nearer.
template <int D>
[[nodiscard]] Vector<D> place_on(const WayScene& way, double time) {
  const auto after = std::ranges::upper_bound(way.times, time);
  const auto next = static_cast<std::size_t>(after - way.times.begin());
  const bool is_outside = next == 0 || after == way.times.end();
  const std::size_t last = next == 0 ? 0 : next - 1;
  const double share = is_outside ? 0 : (time - way.times[last]) / (way.times[next] - way.times[last]);
  Vector<D> place;
  for (int axis = 0; axis < D; ++axis) {
    const auto& places = way.places[static_cast<std::size_t>(axis)];
    place[axis] = is_outside ? places[last] : places[last] + share * (places[next] - places[last]);
  }
  return place;
}

/// A body that does not move has no functions of time.
template <int D>
[[nodiscard]] mpm::RigidMotion<D> motion_of(const BodyScene& body) {
  const Vector<D> pivot = vector_of<D>(body.pivot);
  const Vector<D> velocity = vector_of<D>(body.velocity);
  const auto moving_time = [start = body.start, stop = body.stop](double time) {
    return std::clamp(time, start, stop) - start;
  };
  mpm::RigidMotion<D> motion;
  motion.pivot = pivot;
  motion.axis = Vector<3>{body.axis[0], body.axis[1], body.axis[2]};
  if (velocity.norm() > 0) {
    motion.place = [=](double time) -> Vector<D> { return pivot + moving_time(time) * velocity; };
  }
  if (!body.way.times.empty()) {
    motion.place = [way = body.way](double time) { return place_on<D>(way, time); };
  }
  if (body.angular_velocity != 0) {
    motion.angle = [moving_time, omega = body.angular_velocity](double time) {
      return omega * moving_time(time);
    };
  }
  return motion;
}

}  // namespace

template <int D>
mpm::AnySurface<D> surface_of(const BodyScene& body) {
  return std::visit([](const auto& surface) { return made<D>(surface); }, body.surface);
}

template <int D>
std::unique_ptr<mpm::Boundary<D>> make_body(const BodyScene& body, Symmetry symmetry,
                                            const PlaceOfMean& place_of) {
  return with_contact(body.contact, [&]<class Law>(const mpm::Contact<Law>& contact,
                                                   const typename Law::template Input<double>& input) {
    return mpm::make_rigid_body<D, Law>(contact, surface_of<D>(body), motion_of<D>(body), 0, input, symmetry,
                                        carried_input<Law>(body.contact.of_material, place_of));
  });
}

template mpm::AnySurface<2> surface_of(const BodyScene&);
template std::unique_ptr<mpm::Boundary<2>> make_body(const BodyScene&, Symmetry, const PlaceOfMean&);
template mpm::AnySurface<3> surface_of(const BodyScene&);
template std::unique_ptr<mpm::Boundary<3>> make_body(const BodyScene&, Symmetry, const PlaceOfMean&);

}  // namespace scree::app
