#pragma once

#include <scree/mpm/shapes.hpp>
#include <scree/mpm/transfers.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace scree::mpm {

namespace detail {

template <class Variant>
struct Entries;
template <class... Entry>
struct Entries<std::variant<Entry...>> {
  static std::vector<std::variant<Entry...>> all() { return {Entry{}...}; }
};

}  // namespace detail

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

/// A shape function and a transfer, chosen when a test runs: a typed suite would compile each of its tests
/// once for every pair.
struct Scheme {
  AnyShape shape;
  AnyTransfer rule;

  [[nodiscard]] std::size_t support() const {
    return std::visit([](const auto& entry) { return entry.support; }, shape);
  }
  [[nodiscard]] double shift() const {
    return std::visit([](const auto& entry) { return entry.shift; }, shape);
  }
  [[nodiscard]] bool has_affine() const {
    return std::visit([](const auto& entry) { return entry.has_affine; }, rule);
  }
  [[nodiscard]] bool has_affine_gradient() const {
    return std::visit([](const auto& entry) { return entry.has_affine_gradient; }, rule);
  }
  [[nodiscard]] bool has_increment() const {
    return std::visit([](const auto& entry) { return entry.has_increment; }, rule);
  }
  [[nodiscard]] double increment_share() const {
    return std::visit([](const auto& entry) { return entry.increment_share(); }, rule);
  }
  [[nodiscard]] std::string name() const {
    const auto name_of = [](const auto& entry) { return std::string{entry.name}; };
    return std::visit(name_of, shape) + " " + std::visit(name_of, rule);
  }
};

/// Every shape with every transfer; a new entry of a list joins by itself.
[[nodiscard]] inline std::vector<Scheme> every_scheme() {
  std::vector<Scheme> schemes;
  for (const AnyShape& shape : every<AnyShape>()) {
    for (const AnyTransfer& rule : every<AnyTransfer>()) schemes.push_back({shape, rule});
  }
  return schemes;
}

/// What suites run over that hold in one, two and three dimensions.
using Dimensions = ::testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 2>,
                                    std::integral_constant<int, 3>>;

}  // namespace scree::mpm
