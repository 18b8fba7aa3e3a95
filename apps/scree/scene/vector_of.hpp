#pragma once

#include <scree/tensor.hpp>

#include <vector>

namespace scree::app {

/// The first D numbers of a scene's list.
template <int D>
[[nodiscard]] Vector<D> vector_of(const std::vector<double>& numbers) {
  return Eigen::Map<const Vector<D>>{numbers.data()};
}

}  // namespace scree::app
