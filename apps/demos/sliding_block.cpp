// A block slides down a bed with dry friction: x = g (sin a - mu cos a) t^2/2.                   Eq. (M63)
//
// At 24 degrees, with mu = tan 15 degrees, that is 19.86 m after 5 s. The bed cuts the mesh obliquely: it is
// a surface, told by the distance to it, and holds the nodes that feel its pressure, whichever these are.
#include "elastic.hpp"
#include "output.hpp"

#include <scree/mpm/boundaries/bed.hpp>
#include <scree/mpm/step.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

using namespace scree;
using namespace scree::mpm;

namespace {
constexpr double g = 9.81;                                // [m/s^2]
constexpr double slope = 24 * std::numbers::pi / 180;     // a
const double friction = std::tan(std::numbers::pi / 12);  // mu
constexpr double edge = 0.125;                            // of a point's share, half a cell [m]
constexpr demo::Elastic rock{.bulk_modulus = 1e6, .shear_modulus = 6e5, .density = 1000};
constexpr Threads threads{1};
const Vector<2> downhill{std::cos(slope), -std::sin(slope)};
const Vector<2> normal{std::sin(slope), std::cos(slope)};

/// Dry friction. How the law of a wall is written is the idea of `own_wall`.
struct Dry {
  static constexpr std::string_view name = "dry";
  template <class Real>
  struct Input {};
  static constexpr std::array<InputColumn, 0> inputs{};

  template <class Real>
  [[nodiscard]] Real traction(const Real& pressure, const Real&, const Input<Real>&) const noexcept {
    return friction * pressure;
  }
  template <class Real>
  [[nodiscard]] Real slowed(const Real& speed, const WallContact<Real>& contact,
                            const Input<Real>&) const noexcept {
    return std::max(Real(0), speed - contact.mobility * friction * contact.pressure);
  }
};

/// 8 x 4 points in rows along the bed, a corner of theirs at `corner`.
Particles<2> block_at(const Vector<2>& corner) {
  Particles<2> block;
  block.resize(32);
  for (Index p = 0; p < block.size(); ++p) {
    const Index row = p / 8;
    const Vector<2> x = corner + edge * (static_cast<double>(p % 8) + 0.5) * downhill +
                        edge * (static_cast<double>(row) + 0.5) * normal;
    for (int axis = 0; axis < 2; ++axis) block.position.component(axis)[p] = x[axis];
    block.density.component(0)[p] = 1000;
    block.mass.component(0)[p] = 1000 * edge * edge;
  }
  return block;
}

/// How far the middle of all points is down the bed [m].
double place_of(const Particles<2>& block) {
  Vector<2> moment = Vector<2>::Zero();
  for (Index p = 0; p < block.size(); ++p) {
    for (int d = 0; d < 2; ++d) moment[d] += block.mass.component(0)[p] * block.position.component(d)[p];
  }
  return moment.dot(downhill) / (32 * 1000 * edge * edge);
}
}  // namespace

int main(int argc, char** argv) {
  const CartesianGrid<2> grid{Vector<2>{0, 0}, Vector<2>{2 * edge, 2 * edge}, {88, 48}, {false, false}};
  const Vector<2> foot{0.5, 10};
  Particles<2> block = block_at(foot + 0.5 * downhill);
  Stages<2, 2> stages;
  stages.stress = std::make_unique<StressUpdateBy<2, 2, demo::Elastic>>(rock, block);
  stages.transfer = make_transfer<2, 2>(Quadratic{}, Apic{});
  stages.gravity = {0, -g};
  stages.boundaries.push_back(make_bed<2>(Contact<Dry>{}, grid, PlaneSurface<2>{foot, normal}));
  auto state = start(std::move(block), grid, stages, threads);
  const double begin = place_of(state.particles);
  const double acceleration = g * (std::sin(slope) - friction * std::cos(slope));
  std::vector<demo::Column> slide{{"time", {}}, {"way", {}}, {"theory", {}}};
  for (int frame = 0; frame <= 50; ++frame) {
    const double time = 0.1 * frame;
    for (double left = frame == 0 ? 0 : 0.1; left > 0;) {
      const double dt = std::min(stable_time_step(grid, state.rates, {}).dt, left);
      step(state, stages, dt, threads);
      left -= dt;
    }
    slide[0].values.push_back(time);
    slide[1].values.push_back(place_of(state.particles) - begin);
    slide[2].values.push_back(acceleration * time * time / 2);
  }
  demo::write_table(demo::folder_from(argc, argv) / "sliding_block.csv", slide);
  const double way = slide[1].values.back();
  std::printf("after 5 s: %.3f m, by theory %.3f m\n", way, slide[2].values.back());
  return std::abs(way - 19.859) < 1e-3 * 19.859 ? 0 : 1;  // its weight has yet to run through it
}
