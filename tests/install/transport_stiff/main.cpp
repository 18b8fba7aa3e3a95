// Heat spreads in a rod whose ends let nothing through, in a hundred times the step of an explicit scheme.
#include <scree/grid.hpp>
#include <scree/transport/limiters.hpp>
#include <scree/transport/reconstructions.hpp>
#include <scree/transport_stiff/stiff_solver.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace {

struct Heat {
  static constexpr int num_components = 1;
  using State = std::array<double, 1>;
  double diffusivity;  // [m^2/s]

  State flux(const State& /*u*/, const scree::Vector<1>& /*normal*/) const noexcept { return {0}; }
  double max_speed(const State&, const State&, const scree::Vector<1>&) const noexcept { return 0; }
  State potential(const State& u) const noexcept { return {diffusivity * u[0]}; }
  double max_diffusivity(const State&, const State&) const noexcept { return diffusivity; }
};

}  // namespace

int main() {
  namespace transport = scree::transport;
  using Vector = scree::Vector<1>;
  const scree::CartesianGrid<1> rod{Vector{0.0}, Vector{0.01}, {100}, {false}};
  transport::StiffSolver solver{transport::Cartesian<1>{rod.cells()},
                                Heat{1.0},
                                transport::PiecewiseLinear{transport::Minmod{2}},
                                {.largest_step = 0.005}};
  std::vector<double> u(100, 0.0);
  std::fill(u.begin(), u.begin() + 50, 1.0);

  const transport::ImexReport report = solver.advance(u, 1.0);

  const double gained = std::accumulate(u.begin(), u.end(), -50.0);
  return report.steps == 200 && std::abs(gained) < 1e-9 && std::abs(u.front() - 0.5) < 1e-4 ? 0 : 1;
}
