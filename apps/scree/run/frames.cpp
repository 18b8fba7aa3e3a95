#include "scree/run/frames.hpp"

#include "scree/scene/axes.hpp"
#include "scree/scene/dimensions.hpp"
#include "scree/scene/material_columns.hpp"

#include <scree/mpm/axisymmetric.hpp>

#include <deque>

namespace scree::app {

namespace {

/// Columns of a frame, component fastest, of the points that weigh something, in their own periods.
template <int D, int V>
class FrameColumns {
 public:
  explicit FrameColumns(const Simulation<D, V>& simulation) : simulation_{simulation} {
    const double* mass = simulation.state.particles.mass.component(0);
    for (Index p = 0; p < simulation.state.particles.size(); ++p) {
      if (mass[p] > 0) points_.push_back(p);
    }
  }

  [[nodiscard]] io::Column of(const mpm::Column& column, io::ColumnKind kind) {
    std::vector<double>& values = storage_.emplace_back();
    values.reserve(points_.size() * static_cast<std::size_t>(column.num_components()));
    for (const Index p : points_) {
      for (int c = 0; c < column.num_components(); ++c) values.push_back(column.component(c)[p]);
    }
    return {column.quantity(), kind, column.num_components(), values, axes_of_components(D)};
  }

  [[nodiscard]] io::Column scalar(const Quantity& quantity, const std::vector<double>& of_all_points) {
    std::vector<double>& values = storage_.emplace_back();
    for (const Index p : points_) values.push_back(of_all_points[static_cast<std::size_t>(p)]);
    return {quantity, io::ColumnKind::scalar, 1, values, {0, 1, 2}};
  }

  /// The field that a scene names; read_scene() admits no others.
  [[nodiscard]] io::Column named(const std::string& field) {
    const auto& particles = simulation_.state.particles;
    if (field == "id") return of(particles.id, io::ColumnKind::scalar);
    if (field == "mass") return of(particles.mass, io::ColumnKind::scalar);
    if (field == "density") return of(particles.density, io::ColumnKind::scalar);
    if (field == "velocity") return of(particles.velocity, io::ColumnKind::vector);
    if (field == "pressure") return scalar({"pressure", "p", "Pa"}, pressures());
    if (field == "shear_rate") return scalar({"shear_rate", "gdot", "1/s"}, shear_rates());
    if (field == "stability_number") {
      return scalar({"stability_number", "C", "-"}, simulation_.stability_numbers());
    }
    const mpm::Column& column = particles.column(particles.find_column(field, "the output"));
    return of(column, field == fraction_column ? io::ColumnKind::classes : io::ColumnKind::scalar);
  }

 private:
  [[nodiscard]] std::vector<double> pressures() const {
    std::vector<double> pressure(static_cast<std::size_t>(simulation_.state.particles.size()));
    simulation_.stages().stress->pressure(simulation_.state.particles, pressure);
    return pressure;
  }
  [[nodiscard]] std::vector<double> shear_rates() const {
    std::vector<double> rates;
    const auto hoop = mpm::hoop_columns_of(simulation_.state.particles);
    for (Index p = 0; p < simulation_.state.particles.size(); ++p) {
      rates.push_back(shear_rate(mpm::velocity_gradient_of(simulation_.state.particles, p, hoop)));
    }
    return rates;
  }

  const Simulation<D, V>& simulation_;
  std::vector<Index> points_;
  std::deque<std::vector<double>> storage_;  // a deque: columns keep pointing at what they were given
};

}  // namespace

template <int D, int V>
void write_frame(const Simulation<D, V>& simulation, io::FrameWriter& writer) {
  FrameColumns<D, V> columns{simulation};
  io::Frame frame;
  frame.time = simulation.clock.time;
  frame.step = simulation.clock.step;
  frame.position = columns.of(simulation.state.particles.position, io::ColumnKind::vector);
  for (const std::string& field : simulation.scene().output.fields)
    frame.columns.push_back(columns.named(field));
  writer.write(frame);
}

#define SCREE_INSTANCE(D, V) template void write_frame(const Simulation<D, V>&, io::FrameWriter&);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::app
