#pragma once

#include <array>
#include <string_view>

namespace scree::mpm {

/// When in a step the stress is brought up to date, and with which velocities of the nodes.
/// @see Eqs. (M126)-(M128), Bardenhagen (2002), \cite bardenhagen2002
enum class Order {
  usl,   ///< update stress last: by the velocities that forces have just changed
  musl,  ///< modified: last, by those that the points' new momentum makes
  usf    ///< first: by those that the points' momentum makes before forces change it
};
inline constexpr std::array<std::string_view, 3> order_names{"usl", "musl", "usf"};

}  // namespace scree::mpm
