#include "scree/walls.hpp"

#include <scree/mpm/boundaries/frictional.hpp>
#include <scree/rheology/columns.hpp>

#include <variant>

namespace scree::app {

namespace {

template <int D>
[[nodiscard]] std::unique_ptr<mpm::Boundary<D>> make(const mpm::AnyWall& wall, int axis, mpm::Side side,
                                                     Symmetry /*symmetry*/) {
  return mpm::make_wall<D>(wall, axis, side);
}

template <int D>
[[nodiscard]] std::unique_ptr<mpm::Boundary<D>> make(const FrictionScene& wall, int axis, mpm::Side side,
                                                     Symmetry symmetry) {
  return std::visit(
      [&](const auto& law) {
        using Law = std::decay_t<decltype(law)>;
        std::size_t next = 0;
        const auto input = rheology::made_of<typename Law::template Input<double>>(
            Law::inputs, [&](const InputColumn& /*column*/) { return wall.inputs.at(next++); });
        return mpm::make_frictional_wall<D>(law, input, wall.hold, axis, side, symmetry);
      },
      wall.law);
}

template <int D>
[[nodiscard]] std::unique_ptr<mpm::Boundary<D>> make(const OpenEnd& /*end*/, int /*axis*/, mpm::Side /*side*/,
                                                     Symmetry /*symmetry*/) {
  return nullptr;
}

}  // namespace

template <int D>
std::unique_ptr<mpm::Boundary<D>> make_boundary(const WallScene& wall, int axis, mpm::Side side,
                                                Symmetry symmetry) {
  return std::visit([&](const auto& kind) { return make<D>(kind, axis, side, symmetry); }, wall);
}

template std::unique_ptr<mpm::Boundary<1>> make_boundary(const WallScene&, int, mpm::Side, Symmetry);
template std::unique_ptr<mpm::Boundary<2>> make_boundary(const WallScene&, int, mpm::Side, Symmetry);
template std::unique_ptr<mpm::Boundary<3>> make_boundary(const WallScene&, int, mpm::Side, Symmetry);

}  // namespace scree::app
