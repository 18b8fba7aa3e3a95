#include "bodies.hpp"

#include <gtest/gtest.h>

namespace scree::mpm {
namespace {

/// Sets the first velocity component of every node that is not on the low end of axis 0, and keeps what it
/// found on it.
class Sweep final : public NodeSolve<1, 1> {
 public:
  explicit Sweep(double& at_wall) : at_wall_{at_wall} {}
  void solve(const Particles<1, 1>& /*particles*/, Nodes<1>& nodes, double /*dt*/,
             double /*mass_floor*/) override {
    at_wall_ = nodes[nodes.place(0, 0)][NodeRecord::momentum];
    for (Index node = 1; node < nodes.grid().nodes().num_sites(); ++node) {
      nodes[nodes.place(node, 0)][NodeRecord::momentum] = 3;
    }
  }

 private:
  double& at_wall_;
};

TEST(NodeSolve, SeesWallsThatHoldAndChangesWhatPointsFollow) {  // Eq. (M29)
  const auto grid = cube<1>(4, 0.1, false);
  auto particles = filled<1>(grid, 1);
  for (double& v : particles.velocity.values()) v = -1;
  auto stages = stages_of<1, 1>(particles, Linear{}, Apic{});
  stages.boundaries.push_back(make_wall<1>(NoSlip{}, 0, Side::low));
  double at_wall = -7;
  stages.node_solve = std::make_unique<Sweep>(at_wall);
  auto state = start(std::move(particles), grid, stages, Threads{1});

  step(state, stages, 1e-3, Threads{1});

  EXPECT_EQ(at_wall, 0);
  for (Index p = 0; p < state.particles.size(); ++p) {
    if (state.particles.mass.component(0)[p] == 0) continue;
    const bool is_by_wall = state.particles.id.component(0)[p] == 0;
    EXPECT_DOUBLE_EQ(state.particles.velocity.component(0)[p], is_by_wall ? 1.5 : 3);
  }
}

TEST(StressUpdate, TellsTheViscosityOfEachPointOfABlock) {
  const auto grid = cube<1>(4, 0.1, false);
  auto particles = filled<1>(grid, 1);
  const Fluid mud{.bulk_modulus = 1e5, .reference_density = 1000, .viscosity = 2};
  const auto stages = stages_of<1, 1>(particles, Linear{}, Apic{}, mud);
  std::vector<double> viscosity(4, -1.0);

  stages.stress->viscosity(particles, {{0}, 1, 3}, viscosity);

  EXPECT_EQ(viscosity, (std::vector<double>{-1, 2, 2, -1}));
}

}  // namespace
}  // namespace scree::mpm
