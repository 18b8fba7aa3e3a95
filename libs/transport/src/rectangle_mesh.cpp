#include <scree/error.hpp>
#include <scree/transport/grids/rectangle_mesh.hpp>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace scree::transport {
namespace {

constexpr double most_perturbation = 0.3;
constexpr double most_distortion = 0.1;
// Part of the perturbation that hexagons take [-]: three vertices in a row stay convex.
constexpr double room_of_hexagons = 0.4;

/// Uniform numbers in [0, 1), the same with every standard library.
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : engine_{seed} {}
  double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 engine_;
};

void check(const Rectangle& rectangle) {
  require(rectangle.low.allFinite() && rectangle.high.allFinite() && rectangle.low[0] < rectangle.high[0] &&
              rectangle.low[1] < rectangle.high[1],
          "Rectangle: `high` must lie above and to the right of `low`, both finite");
  require(rectangle.count[0] >= 1 && rectangle.count[1] >= 1,
          "Rectangle: each axis must have at least one cell");
  require(0 <= rectangle.perturbation && rectangle.perturbation <= most_perturbation,
          "Rectangle: the perturbation must lie in [0, 0.3]");
  require(0 <= rectangle.distortion && rectangle.distortion <= most_distortion,
          "Rectangle: the distortion must lie in [0, 0.1]");
}

/// A mesh in the making, in units of cells: vertices on a lattice of columns x rows.
class Draft {
 public:
  /// @param room part of the perturbation that the cells have room for [-]
  Draft(const Rectangle& rectangle, Index columns, Index rows, double room)
      : rectangle_{rectangle}, columns_{columns}, rows_{rows}, room_{room}, random_{rectangle.seed} {
    mesh.boundary_names = {"left", "right", "bottom", "top"};
  }

  PolygonalMesh mesh;

  [[nodiscard]] Index vertex(Index column, Index row) const { return row * (columns_ + 1) + column; }
  [[nodiscard]] bool flip() { return random_() < 0.5; }
  [[nodiscard]] double random() { return random_(); }

  /// Adds all vertices, inner ones moved. @param shift along the second axis, of inner vertices [rows]
  template <class Shift>
  void add_vertices(const Shift& shift) {
    const Vector<2> size = rectangle_.high - rectangle_.low;
    const Vector<2> cell{size[0] / static_cast<double>(columns_), size[1] / static_cast<double>(rows_)};
    for (Index row = 0; row <= rows_; ++row) {
      for (Index column = 0; column <= columns_; ++column) {
        Vector<2> x{static_cast<double>(column) / static_cast<double>(columns_),
                    static_cast<double>(row) / static_cast<double>(rows_)};  // exact at both ends
        const bool is_row_inside = 0 < row && row < rows_;
        const bool is_inside = is_row_inside && 0 < column && column < columns_;
        if (is_row_inside) x[1] += shift(column, row) / static_cast<double>(rows_);
        const double wave = std::sin(2 * std::numbers::pi * x[0]) * std::sin(2 * std::numbers::pi * x[1]);
        Vector<2> position = rectangle_.low + x.cwiseProduct(size);
        if (is_inside) {
          position += rectangle_.distortion * wave * size;
          const Vector<2> step{2 * random_() - 1, 2 * random_() - 1};
          position += room_ * rectangle_.perturbation * step.cwiseProduct(cell);
        }
        mesh.vertices.push_back(position);
      }
    }
  }

  void add_boundaries() {
    for (Index row = 0; row < rows_; ++row) {
      mesh.boundary_edges.push_back({vertex(0, row), vertex(0, row + 1), 0});
      mesh.boundary_edges.push_back({vertex(columns_, row), vertex(columns_, row + 1), 1});
    }
    for (Index column = 0; column < columns_; ++column) {
      mesh.boundary_edges.push_back({vertex(column, 0), vertex(column + 1, 0), 2});
      mesh.boundary_edges.push_back({vertex(column, rows_), vertex(column + 1, rows_), 3});
    }
    const Vector<2> size = rectangle_.high - rectangle_.low;
    if (rectangle_.is_periodic[0]) mesh.periodic_pairs.push_back({"left", "right", Vector<2>{size[0], 0}});
    if (rectangle_.is_periodic[1]) mesh.periodic_pairs.push_back({"bottom", "top", Vector<2>{0, size[1]}});
  }

  void add(std::vector<Index> polygon) { mesh.add_cell(polygon); }

 private:
  const Rectangle& rectangle_;
  Index columns_;
  Index rows_;
  double room_;
  Uniform random_;
};

/// Quadrilaterals, each cut in two or not.
PolygonalMesh quadrilaterals(const Rectangle& rectangle, bool is_cut) {
  Draft draft{rectangle, rectangle.count[0], rectangle.count[1], 1};
  draft.add_vertices([](Index, Index) { return 0.0; });
  for (Index row = 0; row < rectangle.count[1]; ++row) {
    for (Index column = 0; column < rectangle.count[0]; ++column) {
      const Index a = draft.vertex(column, row);
      const Index b = draft.vertex(column + 1, row);
      const Index c = draft.vertex(column + 1, row + 1);
      const Index d = draft.vertex(column, row + 1);
      if (!is_cut) {
        draft.add({a, b, c, d});
      } else if (draft.flip()) {
        draft.add({a, b, c});
        draft.add({a, c, d});
      } else {
        draft.add({a, b, d});
        draft.add({b, c, d});
      }
    }
  }
  draft.add_boundaries();
  return std::move(draft.mesh);
}

/// Bricks, rows in turn half a brick apart; the vertices in the middle of a side are pulled outward, which
/// makes hexagons. Some are cut in two quadrilaterals, some of these in triangles.
PolygonalMesh hexagons(const Rectangle& rectangle) {
  const Index columns = 2 * rectangle.count[0];
  const Index rows = rectangle.count[1];
  Draft draft{rectangle, columns, rows, room_of_hexagons};
  constexpr double pull = 1.0 / 8;  // of a row
  draft.add_vertices([&](Index column, Index row) {
    if (column == 0 || column == columns) return 0.0;
    return (column + row) % 2 == 0 ? pull : -pull;  // even: a corner of the row above, mid-side of that below
  });
  const auto add_half = [&](Index column, Index row) {  // half a brick: a quadrilateral
    const Index a = draft.vertex(column, row);
    const Index b = draft.vertex(column + 1, row);
    const Index c = draft.vertex(column + 1, row + 1);
    const Index d = draft.vertex(column, row + 1);
    if (draft.random() < 0.3) {
      draft.add({a, b, c});
      draft.add({a, c, d});
    } else {
      draft.add({a, b, c, d});
    }
  };
  for (Index row = 0; row < rows; ++row) {
    Index column = 0;
    if (row % 2 == 1) add_half(column++, row);
    for (; column + 2 <= columns; column += 2) {
      if (draft.random() < 0.3) {
        add_half(column, row);
        add_half(column + 1, row);
      } else {
        draft.add({draft.vertex(column, row), draft.vertex(column + 1, row), draft.vertex(column + 2, row),
                   draft.vertex(column + 2, row + 1), draft.vertex(column + 1, row + 1),
                   draft.vertex(column, row + 1)});
      }
    }
    if (column < columns) add_half(column, row);
  }
  draft.add_boundaries();
  return std::move(draft.mesh);
}

}  // namespace

PolygonalMesh make_mesh(const Rectangle& rectangle) {
  check(rectangle);
  if (rectangle.cut == Cut::mixed) return hexagons(rectangle);
  return quadrilaterals(rectangle, rectangle.cut == Cut::triangles);
}

}  // namespace scree::transport
