#pragma once

#include <scree/mpm/shapes.hpp>
#include <scree/mpm/transfers.hpp>

#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

namespace scree::mpm {

/// A shape function, a transfer and a dimension: what the typed suites of momentum run over.
template <class ShapeType_, class Rule_, int D_>
struct Scheme {
  using ShapeType = ShapeType_;
  using Rule = Rule_;
  static constexpr int D = D_;
};

namespace detail {

template <class... Lists>
struct Joined;
template <class... A>
struct Joined<::testing::Types<A...>> {
  using type = ::testing::Types<A...>;
};
template <class... A, class... B, class... Rest>
struct Joined<::testing::Types<A...>, ::testing::Types<B...>, Rest...> {
  using type = typename Joined<::testing::Types<A..., B...>, Rest...>::type;
};

template <class Shapes, class Rules, int D>
struct SchemesIn;
template <class... S, class... R, int D>
struct SchemesIn<std::variant<S...>, std::variant<R...>, D> {
  template <class One>
  using Row = ::testing::Types<Scheme<One, R, D>...>;
  using type = typename Joined<Row<S>...>::type;
};
template <int D>
using AllIn = typename SchemesIn<AnyShape, AnyTransfer, D>::type;

template <class Variant>
struct Entries;
template <class... Entry>
struct Entries<std::variant<Entry...>> {
  static std::vector<std::variant<Entry...>> all() { return {Entry{}...}; }
};

}  // namespace detail

/// Every shape with every transfer in one, two and three dimensions; a new entry of a list joins by itself.
using EverySchemeList = detail::Joined<detail::AllIn<1>, detail::AllIn<2>, detail::AllIn<3>>::type;

struct SchemeName {
  template <class S>
  static std::string GetName(int /*number*/) {
    return std::string{S::ShapeType::name} + "_" + std::string{S::Rule::name} + "_" + std::to_string(S::D) +
           "d";
  }
};

/// One of each entry of a list, with its default parameters.
template <class Variant>
[[nodiscard]] std::vector<Variant> every() {
  return detail::Entries<Variant>::all();
}

/// One of each shape, those whose boxes fill the cells made for so many points along each axis of a cell.
[[nodiscard]] inline std::vector<AnyShape> every_shape_for(double points_per_axis) {
  std::vector<AnyShape> shapes = every<AnyShape>();
  for (AnyShape& shape : shapes) {
    if (std::holds_alternative<Gimp>(shape)) shape = Gimp{points_per_axis};
  }
  return shapes;
}

}  // namespace scree::mpm
