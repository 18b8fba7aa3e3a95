#include <scree/mpm/boundaries.hpp>

namespace scree::mpm {

namespace {

template <int D, class Rule>
class MirrorWall final : public Boundary<D> {
 public:
  MirrorWall(int axis, Side side) : axis_{static_cast<std::size_t>(axis)}, side_{side} {}

  void fold(Nodes<D>& nodes, const double* gravity, double dt) const noexcept override {
    const NodeRecord layout = nodes.record();
    const int force = layout.has_increment ? layout.increment() : NodeRecord::momentum;
    const double time = layout.has_increment ? 1 : dt;  // a force is kept as it is, or given as momentum
    for_each_wall_line(nodes, axis_, side_, [&](double* image, double*, double* inside, Index) {
      inside[NodeRecord::mass] += image[NodeRecord::mass];
      for_each_component(layout, [&](int place, double parity) { inside[place] += parity * image[place]; });
      for (int i = 0; i < layout.num_velocities; ++i) {  // its mass will fall, its mirrored weight would rise
        if (!holds(i)) continue;
        inside[force + i] -= 2 * time * image[NodeRecord::mass] * gravity[i];
      }
    });
  }

  void hold(Nodes<D>& nodes, double /*dt*/) const noexcept override {
    const NodeRecord layout = nodes.record();
    for_each_wall_line(nodes, axis_, side_, [&](double*, double* wall, double*, Index) {
      for (int i = 0; i < layout.num_velocities; ++i) {
        if (!holds(i)) continue;
        if (layout.has_increment) wall[layout.increment() + i] = 0;
        wall[NodeRecord::momentum + i] = 0;
      }
    });
  }

  void reflect(Nodes<D>& nodes) const noexcept override {
    const NodeRecord layout = nodes.record();
    for_each_wall_line(nodes, axis_, side_, [&](double* image, double*, double* inside, Index) {
      for_each_component(layout, [&](int place, double parity) { image[place] = parity * inside[place]; });
    });
  }

 private:
  [[nodiscard]] bool holds(int component) const noexcept {
    return Rule::holds(component, static_cast<int>(axis_));
  }

  /// Calls body(place in the record, -1 or +1) for every component of velocity and of its increment.
  template <class Body>
  void for_each_component(const NodeRecord& layout, Body&& body) const noexcept {
    for (int i = 0; i < layout.num_velocities; ++i) {
      const double parity = holds(i) ? -1 : 1;
      body(NodeRecord::momentum + i, parity);
      if (layout.has_increment) body(layout.increment() + i, parity);
    }
  }

  std::size_t axis_;
  Side side_;
};

}  // namespace

template <int D>
std::unique_ptr<Boundary<D>> make_wall(const AnyWall& rule, int axis, Side side) {
  require(0 <= axis && axis < D, "make_wall: no such axis");
  return std::visit(
      [&](auto chosen) -> std::unique_ptr<Boundary<D>> {
        return std::make_unique<MirrorWall<D, decltype(chosen)>>(axis, side);
      },
      rule);
}

template std::unique_ptr<Boundary<1>> make_wall<1>(const AnyWall&, int, Side);
template std::unique_ptr<Boundary<2>> make_wall<2>(const AnyWall&, int, Side);
template std::unique_ptr<Boundary<3>> make_wall<3>(const AnyWall&, int, Side);

}  // namespace scree::mpm
