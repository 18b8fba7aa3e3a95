#pragma once

namespace scree::mpm {

/// Whether material may leave a wall.
enum class Hold {
  pushes,           ///< it may: the wall pushes and does not pull
  pushes_and_pulls  ///< it may not: no velocity through the wall either way
};

}  // namespace scree::mpm
