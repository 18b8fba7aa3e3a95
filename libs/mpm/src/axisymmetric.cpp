#include "point_text.hpp"
#include "stencil.hpp"

#include <scree/mpm/axisymmetric.hpp>
#include <scree/mpm/hoop_columns.hpp>

#include <array>
#include <cmath>
#include <variant>

namespace scree::mpm {

namespace {

template <class ShapeType>
class HoopTerm final : public PointTerm<2, 2> {
 public:
  HoopTerm(const ShapeType& shape, const CartesianGrid<2>& grid, const HoopColumns& hoop, std::size_t radius)
      : shape_{shape}, origin_{grid.origin()[0]}, hoop_{hoop}, radius_{radius} {}

  void scatter(Particles<2, 2>& particles, const ParticleBlock<2>& block, Nodes<2>& nodes,
               double dt) const noexcept override {
    const double* const x = particles.position.component(0);
    const double* const stress = particles.column(hoop_.stress).component(0);
    double* const radius = particles.column(radius_).component(0);
    const NodeRecord layout = nodes.record();
    const int place = layout.has_increment ? layout.increment() : NodeRecord::momentum;
    const double time = layout.has_increment ? 1 : dt;  // a force is kept as it is, or given as momentum
    for (Index p = block.begin; p < block.end; ++p) {
      radius[p] = x[p] - origin_;
      const double volume = particles.mass.component(0)[p] / particles.density.component(0)[p];
      const double force = -volume * stress[p] / radius[p];  // Eq. (M151)
      for_each_node(particles, p, block, nodes,
                    [&](double* node, double weight) { node[place] += time * weight * force; });
    }
  }

  void gather(Particles<2, 2>& particles, const ParticleBlock<2>& block, double dt) const noexcept override {
    const double* const x = particles.position.component(0);
    const double* const radius = particles.column(radius_).component(0);
    double* const rate = particles.column(hoop_.rate).component(0);
    for (Index p = block.begin; p < block.end; ++p) {
      const double stretch = std::abs(x[p] - origin_) / radius[p];  // past the axis it comes out on this side
      rate[p] = (stretch - 1) / dt;
      particles.density.component(0)[p] /= stretch;  // Eq. (M153)
    }
  }

 private:
  template <class Body>
  void for_each_node(const Particles<2, 2>& particles, Index p, const ParticleBlock<2>& block,
                     Nodes<2>& nodes, Body&& body) const noexcept {
    constexpr std::size_t S = ShapeType::support;
    std::array<std::array<double, S>, 2> weight;
    std::array<Index, 2> base;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const int a = static_cast<int>(axis);
      const auto at =
          detail::place_in_block<ShapeType>(particles.position.component(a)[p], nodes.grid(), a, block);
      base[axis] = at.base;
      weight[axis] = shape_.weights(at.xi);
    }
    for (std::size_t j = 0; j < S; ++j) {
      const Index row = nodes.place(base[1] + static_cast<Index>(j), 1) * nodes.stride(1);
      for (std::size_t i = 0; i < S; ++i) {
        const Index node = row + nodes.place(base[0] + static_cast<Index>(i), 0) * nodes.stride(0);
        body(nodes[node], weight[0][i] * weight[1][j]);
      }
    }
  }

  ShapeType shape_;
  double origin_;
  HoopColumns hoop_;
  std::size_t radius_;  // column: where the points were when they were scattered [m]
};

}  // namespace

std::unique_ptr<PointTerm<2, 2>> make_axisymmetric(Particles<2, 2>& particles, const CartesianGrid<2>& grid,
                                                   const AnyShape& shape) {
  require(!grid.is_periodic()[0], "make_axisymmetric: axis 0 is the radius and cannot be periodic");
  for (Index p = 0; p < particles.size(); ++p) {
    const double radius = particles.position.component(0)[p] - grid.origin()[0];
    require(radius > 0, "make_axisymmetric: the radius of " + point_text(particles, p) + " must be positive");
    particles.mass.component(0)[p] *= radius;
  }
  const HoopColumns hoop = add_hoop_columns(particles);
  const std::size_t radius = particles.add_column({"radius", "r", "m"}, 1);
  return std::visit(
      [&](const auto& one) -> std::unique_ptr<PointTerm<2, 2>> {
        return std::make_unique<HoopTerm<std::decay_t<decltype(one)>>>(one, grid, hoop, radius);
      },
      shape);
}

}  // namespace scree::mpm
