#pragma once

#include <array>

namespace scree::rheology {

// From slow creep to a fast avalanche, and from a film of grains to a hundred metres of rock.
inline constexpr std::array<double, 8> speeds{0, 1e-6, 1e-3, 0.013, 0.1, 1, 30, 200};             // [m/s]
inline constexpr std::array<double, 6> pressures{0, 1, 30, 1e3, 1e5, 2e6};                        // [Pa]
inline constexpr std::array<double, 6> mobilities{1e-12, 1e-8, 1e-6, 1.0 / 3e4, 1.0 / 300, 0.1};  // [m/s/Pa]

}  // namespace scree::rheology
