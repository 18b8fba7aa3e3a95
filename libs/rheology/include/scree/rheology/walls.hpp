#pragma once

#include <scree/rheology/walls/coulomb.hpp>
#include <scree/rheology/walls/material_friction.hpp>
#include <scree/rheology/walls/pouliquen_forterre.hpp>
#include <scree/rheology/walls/voellmy.hpp>

#include <variant>

namespace scree::rheology {

/// Every friction of a wall. A new one is a line here, and every property test runs on it.
using AnyWallLaw = std::variant<Coulomb, MaterialFriction, PouliquenForterre, Voellmy>;

}  // namespace scree::rheology
