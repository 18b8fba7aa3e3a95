#include <scree/error.hpp>
#include <scree/transport/grids/rectilinear.hpp>

#include <cmath>
#include <sstream>
#include <utility>

namespace scree::transport {
namespace {

void require_increasing(std::span<const double> edges, std::size_t axis) {
  std::ostringstream text;
  text << "Rectilinear: ";
  if (edges.size() < 2) {
    text << "axis " << axis << " has " << edges.size() << " edges: must have two or more";
    throw InputError{text.str()};
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (!std::isfinite(edges[i])) {
      text << "edge " << i << " of axis " << axis << " is " << edges[i] << " m: must be finite";
      throw InputError{text.str()};
    }
    if (i > 0 && !(edges[i] > edges[i - 1])) {
      text << "edge " << i << " of axis " << axis << " is " << edges[i] << " m: must exceed edge " << i - 1
           << ", " << edges[i - 1] << " m";
      throw InputError{text.str()};
    }
  }
}

}  // namespace

template <int D>
Rectilinear<D>::Rectilinear(std::array<std::vector<double>, static_cast<std::size_t>(D)> edges,
                            const std::array<bool, D>& is_periodic)
    : edges_{std::move(edges)}, is_periodic_{is_periodic} {
  for (std::size_t axis = 0; axis < D; ++axis) {
    require_increasing(edges_[axis], axis);
    count_[axis] = static_cast<Index>(edges_[axis].size()) - 1;
  }
}

template class Rectilinear<1>;
template class Rectilinear<2>;
template class Rectilinear<3>;

}  // namespace scree::transport
