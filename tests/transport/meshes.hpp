#pragma once

#include <scree/transport/grids/polygonal.hpp>
#include <scree/transport/grids/rectangle_mesh.hpp>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace scree::transport::test {

/// The mean of `f` over a cell: the rule of the three mid-sides on each triangle that its centre makes with a
/// side, exact for quadratic functions.
template <class Function>
[[nodiscard]] double average(const Polygonal& grid, Index cell, const Function& f) {
  const PolygonalMesh& mesh = grid.mesh();
  const auto corners = mesh.cell(cell);
  const Vector<2>& centre = grid.centre(cell);
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector<2>& a = mesh.vertices[static_cast<std::size_t>(corners[i])];
    const Vector<2>& b = mesh.vertices[static_cast<std::size_t>(corners[(i + 1) % corners.size()])];
    const double area =
        0.5 * ((a[0] - centre[0]) * (b[1] - centre[1]) - (a[1] - centre[1]) * (b[0] - centre[0]));
    const Vector<2> ab = (a + b) / 2;
    const Vector<2> ac = (a + centre) / 2;
    const Vector<2> bc = (b + centre) / 2;
    sum += area * (f(ab) + f(ac) + f(bc)) / 3;
  }
  return sum / grid.volume(cell);
}

template <class Function>
[[nodiscard]] std::vector<double> averages(const Polygonal& grid, const Function& f) {
  std::vector<double> u;
  for (Index cell = 0; cell < grid.num_cells(); ++cell) u.push_back(average(grid, cell, f));
  return u;
}

/// Integral of |a - b|.
[[nodiscard]] inline double l1(const Polygonal& grid, const std::vector<double>& a,
                               const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += grid.volume(static_cast<Index>(i)) * std::abs(a[i] - b[i]);
  return sum;
}

[[nodiscard]] inline double mass(const Polygonal& grid, const std::vector<double>& u) {
  double sum = 0;
  for (std::size_t i = 0; i < u.size(); ++i) sum += grid.volume(static_cast<Index>(i)) * u[i];
  return sum;
}

/// The largest sum of a cell's areas over its volume [1/m]: what a rounding of a flux does to a rate.
[[nodiscard]] inline double largest_area_per_volume(const Polygonal& grid) {
  std::vector<double> areas(static_cast<std::size_t>(grid.num_cells()), 0.0);
  for (Index i = 0; i < grid.num_faces(); ++i) {
    const GridFace<2>& face = grid.face(i);
    areas[static_cast<std::size_t>(face.owner)] += face.area;
    if (face.neighbour != no_site) areas[static_cast<std::size_t>(face.neighbour)] += face.area;
  }
  double largest = 0;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    largest = std::max(largest, areas[i] / grid.volume(static_cast<Index>(i)));
  }
  return largest;
}

/// One of each kind, perturbed; a bad one, triangles fifty times as long as high, with their vertices moved
/// by 0.3 of a cell; and one of so many cells that they are worked on in several patches.
[[nodiscard]] inline std::vector<std::pair<std::string, Rectangle>> rectangles(bool is_periodic) {
  const std::array<bool, 2> periodic{is_periodic, is_periodic};
  const Rectangle triangles{.count = {12, 12}, .perturbation = 0.2, .is_periodic = periodic};
  Rectangle quadrilaterals = triangles;
  quadrilaterals.cut = Cut::quadrilaterals;
  Rectangle mixed = triangles;
  mixed.cut = Cut::mixed;
  Rectangle bad = triangles;
  bad.high[1] = 0.02;
  bad.perturbation = 0.3;
  Rectangle many = triangles;
  many.count = {50, 50};
  return {{"triangles", triangles},
          {"quadrilaterals", quadrilaterals},
          {"mixed", mixed},
          {"bad", bad},
          {"many", many}};
}

}  // namespace scree::transport::test
