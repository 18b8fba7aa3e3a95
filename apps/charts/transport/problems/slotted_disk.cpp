#include "../every_scheme.hpp"
#include "../problems.hpp"

#include <scree/transport/grids/cartesian.hpp>

#include <cmath>
#include <numbers>

namespace scree::charts {
namespace {

/// Advection along one axis, at a given face.
struct FaceSpeed {
  static constexpr int num_components = 1;
  using State = std::array<double, 1>;

  double speed;  ///< [m/s]

  [[nodiscard]] State flux(const State& u, const Vector<2>& /*normal*/) const noexcept {
    return {speed * u[0]};
  }
  [[nodiscard]] double max_speed(const State& /*left*/, const State& /*right*/,
                                 const Vector<2>& /*normal*/) const noexcept {
    return std::abs(speed);
  }
  [[nodiscard]] transport::SpeedRange speed_range(const State& /*left*/, const State& /*right*/,
                                                  const Vector<2>& /*normal*/) const noexcept {
    return {speed, speed};
  }
};

/// Advection by given velocities at the faces.
struct Stream {
  const double* speeds;  ///< along +axis at the face above each site [m/s], one row of num_sites per axis
  Index num_sites;

  [[nodiscard]] FaceSpeed at(const transport::Face& face) const noexcept {
    return {speeds[face.axis * num_sites + face.owner]};
  }
};
static_assert(transport::ConservationLaw<Stream, 2>);

constexpr double radius = 0.15;

Lattice<2> unit_square(Index n) {
  const double dx = 1 / static_cast<double>(n);
  return {.count = {n, n},
          .spacing = Vector<2>::Constant(dx),
          .first = Vector<2>::Constant(dx / 2),
          .is_periodic = {false, false}};
}

/// Velocities of a turn about the centre in 2 pi seconds.
std::vector<double> turn(const Lattice<2>& cells) {
  std::vector<double> along_x;
  std::vector<double> along_y;
  for (Index site = 0; site < cells.num_sites(); ++site) {
    const Vector<2> x = cells.position(cells.site(site));
    along_x.push_back(0.5 - x[1]);
    along_y.push_back(x[0] - 0.5);
  }
  along_x.insert(along_x.end(), along_y.begin(), along_y.end());
  return along_x;
}

bool is_in_disk(const Vector<2>& x) {
  const bool is_in_slot = std::abs(x[0] - 0.5) < 0.025 && x[1] < 0.85;
  return (x - Vector<2>{0.5, 0.75}).norm() < radius && !is_in_slot;
}

/// Averages from 8 x 8 points in each cell.
std::vector<double> disk(const Lattice<2>& cells) {
  constexpr int points = 8;
  std::vector<double> u;
  for (Index site = 0; site < cells.num_sites(); ++site) {
    const Vector<2> centre = cells.position(cells.site(site));
    int inside = 0;
    for (int point = 0; point < points * points; ++point) {
      const int column = point % points;
      const int row = point / points;
      const Vector<2> part{(column + 0.5) / points - 0.5, (row + 0.5) / points - 0.5};
      if (is_in_disk(centre + part.cwiseProduct(cells.spacing))) ++inside;
    }
    u.push_back(static_cast<double>(inside) / (points * points));
  }
  return u;
}

}  // namespace

std::vector<Record> slotted_disk(const Extent& extent) {
  std::vector<Record> records;
  for (const Index n : doublings(20, 4, extent)) {
    const Lattice<2> cells = unit_square(n);
    const auto speeds = turn(cells);
    const auto start = disk(cells);
    const std::vector<Case<transport::Cartesian<2>, Stream>> places{
        {cells, {speeds.data(), cells.num_sites()}, {}, start, start, 2 * std::numbers::pi}};
    double area = 0;
    for (const double u : start) area += u * cells.spacing.prod();
    for (Record& record : run_every_scheme("slotted_disk", n, places, extent.effort)) {
      record.l1 /= area;
      records.push_back(record);
    }
  }
  return records;
}

}  // namespace scree::charts
