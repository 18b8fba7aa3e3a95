#pragma once

#include <scree/index.hpp>
#include <scree/mpm/order.hpp>
#include <scree/mpm/shapes.hpp>
#include <scree/mpm/transfers.hpp>

#include <string>
#include <vector>

namespace scree::charts {

/// One way to step material points.
struct Scheme {
  std::string shape{};
  std::string transfer{};
  mpm::AnyShape any_shape{};
  mpm::AnyTransfer any_transfer{};
  mpm::Order order = mpm::Order::usl;
  int xpic_order = 0;
  Index points_per_axis = 2;  ///< of each cell at first
};

/// Every shape with every transfer in every order of the step on 1, 2 and 3 points per axis.
/// @param is_quick quadratic splines and 2 points alone
[[nodiscard]] std::vector<Scheme> every_scheme(bool is_quick);

}  // namespace scree::charts
