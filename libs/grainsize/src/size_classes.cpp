#include "checks.hpp"

#include <scree/grainsize/size_classes.hpp>

#include <utility>

namespace scree::grainsize {

SizeClasses::SizeClasses(std::vector<double> diameters) : diameters_{std::move(diameters)} {
  require(!diameters_.empty(), "SizeClasses: there must be at least one diameter");
  detail::require_increasing(diameters_, "SizeClasses: diameter");
}

SizeClasses::SizeClasses(std::vector<double> diameters, std::vector<double> edges)
    : SizeClasses{std::move(diameters)} {
  edges_ = std::move(edges);
  if (edges_.size() != size() + 1) {
    throw InputError{detail::message("SizeClasses: ", size(), " classes have ", size() + 1, " edges, but ",
                                     edges_.size(), " are given")};
  }
  detail::require_increasing(edges_, "SizeClasses: edge");
  for (std::size_t k = 0; k < size(); ++k) {
    if (!(edges_[k] <= diameters_[k] && diameters_[k] <= edges_[k + 1])) {
      throw InputError{detail::message("SizeClasses: diameter ", k + 1, " is ", diameters_[k],
                                       " m, but must lie between the edges ", edges_[k], " m and ",
                                       edges_[k + 1], " m")};
    }
  }
}

}  // namespace scree::grainsize
