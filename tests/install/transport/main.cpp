// A step travels once round a ring: nothing is lost, and no new maximum appears.
#include <scree/grid.hpp>
#include <scree/transport/laws/advection.hpp>
#include <scree/transport/limiters.hpp>
#include <scree/transport/reconstructions.hpp>
#include <scree/transport/solver.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

int main() {
  namespace transport = scree::transport;
  using Vector = scree::Vector<1>;
  const scree::CartesianGrid<1> ring{Vector{0.0}, Vector{0.01}, {100}, {true}};
  transport::Solver solver{transport::Cartesian<1>{ring.cells()}, transport::Advection<1>{Vector{1.0}},
                           transport::PiecewiseLinear{transport::VanLeer{}}};
  std::vector<double> u(100, 0.0);
  std::fill(u.begin() + 25, u.begin() + 50, 1.0);

  solver.advance(u, 1.0);

  const double lost = std::accumulate(u.begin(), u.end(), -25.0);
  const double largest = *std::max_element(u.begin(), u.end());
  return std::abs(lost) < 1e-12 && largest < 1 + 1e-12 ? 0 : 1;
}
