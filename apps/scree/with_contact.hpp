#pragma once

#include "scree/scene.hpp"

#include <scree/mpm/boundaries/contact.hpp>
#include <scree/rheology/columns.hpp>

#include <type_traits>
#include <variant>

namespace scree::app {

/// visit(mpm::Contact<Law>, what the law reads) for the law of a contact.
template <class Visit>
auto with_contact(const ContactScene& contact, const Visit& visit) {
  const auto with_law = [&](const auto& law) {
    using Law = std::decay_t<decltype(law)>;
    std::size_t next = 0;
    const auto input = rheology::made_of<typename Law::template Input<double>>(
        Law::inputs, [&](const InputColumn& /*column*/) { return contact.inputs.at(next++); });
    return visit(mpm::Contact<Law>{law, contact.hold}, input);
  };
  if (std::holds_alternative<mpm::Sticks>(contact.law)) return with_law(mpm::Sticks{});
  if (std::holds_alternative<mpm::Slides>(contact.law)) return with_law(mpm::Slides{});
  return std::visit(with_law, std::get<rheology::AnyWallLaw>(contact.law));
}

}  // namespace scree::app
