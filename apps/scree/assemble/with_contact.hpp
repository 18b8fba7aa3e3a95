#pragma once

#include "scree/scene/material_columns.hpp"
#include "scree/scene/scene.hpp"

#include <scree/mpm/boundaries/contact.hpp>
#include <scree/rheology/columns.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <variant>
#include <vector>

namespace scree::app {

/// What a law reads.
/// @param inputs a number per column  @param friction instead of the one there, if it is one
template <class Law>
[[nodiscard]] typename Law::template Input<double> input_of(
    const std::vector<double>& inputs, double friction = std::numeric_limits<double>::quiet_NaN()) {
  std::size_t next = 0;
  return rheology::made_of<typename Law::template Input<double>>(Law::inputs, [&](const InputColumn& column) {
    const double number = inputs.at(next++);
    return column.name == friction_column && std::isfinite(friction) ? friction : number;
  });
}

/// visit(mpm::Contact<Law>, what the law reads) for the law of a contact.
template <class Visit>
auto with_contact(const ContactScene& contact, const Visit& visit) {
  const auto with_law = [&](const auto& law) {
    using Law = std::decay_t<decltype(law)>;
    return visit(mpm::Contact<Law>{law, contact.hold}, input_of<Law>(contact.inputs));
  };
  if (std::holds_alternative<mpm::Sticks>(contact.law)) return with_law(mpm::Sticks{});
  if (std::holds_alternative<mpm::Slides>(contact.law)) return with_law(mpm::Slides{});
  return std::visit(with_law, std::get<rheology::AnyWallLaw>(contact.law));
}

}  // namespace scree::app
