#pragma once

#include <scree/rheology/laws/newtonian.hpp>
#include <scree/rheology/laws/size_dependent_newtonian.hpp>

#include <variant>

namespace scree::rheology {

/// Every constitutive law. A new one is a line here: scenes can then name it, and every property test runs
/// on it.
using AnyLaw = std::variant<Newtonian, SizeDependentNewtonian>;

}  // namespace scree::rheology
