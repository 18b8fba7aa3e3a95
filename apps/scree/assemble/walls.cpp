#include "scree/assemble/walls.hpp"

#include "scree/assemble/with_contact.hpp"

#include <scree/mpm/boundaries/frictional.hpp>

#include <variant>

namespace scree::app {

namespace {

template <int D>
[[nodiscard]] std::unique_ptr<mpm::Boundary<D>> make(const mpm::AnyWall& wall, int axis, mpm::Side side,
                                                     Symmetry /*symmetry*/, const PlaceOfMean& /*place_of*/) {
  return mpm::make_wall<D>(wall, axis, side);
}

template <int D>
[[nodiscard]] std::unique_ptr<mpm::Boundary<D>> make(const FrictionScene& wall, int axis, mpm::Side side,
                                                     Symmetry symmetry, const PlaceOfMean& place_of) {
  return std::visit(
      [&](const auto& law) {
        using Law = std::decay_t<decltype(law)>;
        return mpm::make_frictional_wall<D>(law, input_of<Law>(wall.inputs), wall.hold, axis, side, symmetry,
                                            carried_input<Law>(wall.of_material, place_of));
      },
      wall.law);
}

template <int D>
[[nodiscard]] std::unique_ptr<mpm::Boundary<D>> make(const OpenEnd& /*end*/, int /*axis*/, mpm::Side /*side*/,
                                                     Symmetry /*symmetry*/, const PlaceOfMean& /*place_of*/) {
  return nullptr;
}

}  // namespace

template <int D>
std::unique_ptr<mpm::Boundary<D>> make_boundary(const WallScene& wall, int axis, mpm::Side side,
                                                Symmetry symmetry, const PlaceOfMean& place_of) {
  return std::visit([&](const auto& kind) { return make<D>(kind, axis, side, symmetry, place_of); }, wall);
}

template std::unique_ptr<mpm::Boundary<1>> make_boundary(const WallScene&, int, mpm::Side, Symmetry,
                                                         const PlaceOfMean&);
template std::unique_ptr<mpm::Boundary<2>> make_boundary(const WallScene&, int, mpm::Side, Symmetry,
                                                         const PlaceOfMean&);
template std::unique_ptr<mpm::Boundary<3>> make_boundary(const WallScene&, int, mpm::Side, Symmetry,
                                                         const PlaceOfMean&);

}  // namespace scree::app
