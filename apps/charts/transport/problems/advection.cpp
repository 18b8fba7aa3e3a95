#include "../every_scheme.hpp"
#include "../problems.hpp"
#include "lines.hpp"

#include <scree/transport/grids/cartesian.hpp>
#include <scree/transport/laws/advection.hpp>

#include <cmath>
#include <numbers>

namespace scree::charts {

std::vector<Record> advection(const Extent& extent) {
  using transport::Advection, transport::Cartesian;
  constexpr double period = 2 * std::numbers::pi;
  std::vector<Record> records;
  for (const Index n : doublings(40, 6, extent)) {
    const Lattice<1> cells = line(n, 0, period, true);
    const auto sine = averages(cells, [](double x) { return -std::cos(x); });
    const std::vector<Case<Cartesian<1>, Advection<1>>> places{
        {cells, {Vector<1>{1.0}}, {}, sine, sine, period}};
    std::ranges::copy(run_every_scheme("advection", n, places, extent.effort), std::back_inserter(records));
  }
  return records;
}

}  // namespace scree::charts
