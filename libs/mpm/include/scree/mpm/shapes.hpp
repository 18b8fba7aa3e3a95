#pragma once

#include <scree/mpm/shapes/cubic.hpp>
#include <scree/mpm/shapes/gimp.hpp>
#include <scree/mpm/shapes/linear.hpp>
#include <scree/mpm/shapes/quadratic.hpp>

#include <variant>

namespace scree::mpm {

/// Every shape function of momentum. A new one is a line here, its header and its test.
using AnyShape = std::variant<Cubic, Gimp, Linear, Quadratic>;

}  // namespace scree::mpm
