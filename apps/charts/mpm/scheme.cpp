#include "scheme.hpp"

#include <type_traits>
#include <variant>

namespace scree::charts {

namespace {

/// Calls visit(alternative) for each of a variant's, made as it is untold.
template <class Visit, class... T>
void for_each_alternative(std::type_identity<std::variant<T...>> /*list*/, Visit&& visit) {
  (visit(T{}), ...);
}

/// The transfers of the library by name, with the extremes of a blend and a filtered one beside it.
[[nodiscard]] std::vector<Scheme> every_transfer() {
  std::vector<Scheme> result;
  for_each_alternative(std::type_identity<mpm::AnyTransfer>{}, [&]<class Rule>(const Rule& rule) {
    if constexpr (std::is_same_v<Rule, mpm::PicFlip>) {
      result.push_back({.transfer = "flip", .any_transfer = mpm::PicFlip{1}});
      result.push_back({.transfer = "pic", .any_transfer = mpm::PicFlip{0}});
      result.push_back({.transfer = "xpic_2", .any_transfer = mpm::PicFlip{1}, .xpic_order = 2});
    } else {
      result.push_back({.transfer = std::string{Rule::name}, .any_transfer = rule});
    }
  });
  return result;
}

}  // namespace

std::vector<Scheme> every_scheme(bool is_quick) {
  std::vector<Scheme> result;
  for_each_alternative(std::type_identity<mpm::AnyShape>{}, [&]<class ShapeType>(const ShapeType& shape) {
    if (is_quick && !std::is_same_v<ShapeType, mpm::Quadratic>) return;
    for (Scheme scheme : every_transfer()) {
      scheme.shape = ShapeType::name;
      scheme.any_shape = shape;
      for (const Index points : {1, 2, 3}) {
        if (is_quick && points != 2) continue;
        scheme.points_per_axis = points;
        if constexpr (std::is_same_v<ShapeType, mpm::Gimp>) {
          scheme.any_shape = mpm::Gimp{static_cast<double>(points)};  // boxes that fill the cell
        }
        for (const mpm::Order order : {mpm::Order::usl, mpm::Order::musl, mpm::Order::usf}) {
          scheme.order = order;
          result.push_back(scheme);
        }
      }
    }
  });
  return result;
}

}  // namespace scree::charts
