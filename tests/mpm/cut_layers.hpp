#pragma once

#include "bodies.hpp"
#include "dry_wall.hpp"

#include <scree/mpm/boundaries/frictional.hpp>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace scree::mpm {

/// Cuts shape functions off as they are, without (M183).
template <int D>
class CutAlone final : public Boundary<D> {
 public:
  explicit CutAlone(std::unique_ptr<Boundary<D>> wall) : wall_{std::move(wall)} {}
  void fold(Nodes<D>& nodes, const double* gravity, double dt) const noexcept override {
    wall_->fold(nodes, gravity, dt);
  }
  void hold(Nodes<D>& nodes, double dt) const noexcept override { wall_->hold(nodes, dt); }
  void reflect(Nodes<D>& nodes) const noexcept override { wall_->reflect(nodes); }

 private:
  std::unique_ptr<Boundary<D>> wall_;
};

/// Layers of points beside a wall with friction, which slide along it and press on nothing.
struct Layers {
  static constexpr double h = 0.25;  // [m]

  /// @param places of the layers, from the wall [spacings]
  Layers(const std::vector<double>& places, const AnyShape& shape, const AnyTransfer& rule, bool cuts_alone,
         const Fluid& law = dust, Hold hold = Hold::pushes)
      : state{State<1, 2>{Particles<1, 2>{}, Nodes<1>{cube<1>(8, h, false), {2, true}}}} {
    Particles<1, 2> particles;
    particles.resize(static_cast<Index>(places.size()));
    for (std::size_t p = 0; p < places.size(); ++p) {
      const auto q = static_cast<Index>(p);
      particles.position.component(0)[q] = places[p] * h;
      particles.mass.component(0)[q] = 1;
      particles.density.component(0)[q] = 1000;
      particles.id.component(0)[q] = static_cast<double>(p);
    }
    stages = stages_of<1, 2>(particles, shape, rule, law);
    auto wall = make_frictional_wall<1>(Dry{}, {}, hold, 0, Side::low);
    if (cuts_alone) wall = std::make_unique<CutAlone<1>>(std::move(wall));
    stages.boundaries.push_back(std::move(wall));
    state = start(std::move(particles), cube<1>(8, h, false), stages, {1});
  }
  /// dv_y/dx of a point [1/s].
  [[nodiscard]] double& shear_rate(Index p) { return state.particles.velocity_gradient.component(1)[p]; }
  void advance(int num_steps) {
    for (int n = 0; n < num_steps; ++n) step(state, stages, 1e-3, {1});
  }

  Stages<1, 2> stages;
  State<1, 2> state;
};

}  // namespace scree::mpm
