#include "least_squares.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <span>

namespace scree::transport::detail {
namespace {

// Smallest eigenvalue of the matrix (T32), of the unit vectors to the cells around, that shows every
// direction well enough [-]. An equilateral triangle in one ring has 3/2, three cells in a right angle 1;
// below this a further ring is taken, where there is one.
constexpr double well_seen = 0.05;
// Below it a direction is not seen at all, and the gradient there is zero [-]: rounding of displacements.
constexpr double seen = 1e-10;
constexpr int most_rings = 4;

/// A cell near another one. The same cell may be near twice, across a periodic boundary.
template <int D>
struct Near {
  Index cell;
  Vector<D> displacement;  ///< of its centre [m]
};

template <int D>
class Neighbours {
 public:
  explicit Neighbours(const GridParts<D>& grid) : first_(grid.volumes.size() + 1) {
    for (const GridFace<D>& face : grid.faces) {
      if (face.neighbour == no_site) continue;
      ++first_[static_cast<std::size_t>(face.owner) + 1];
      ++first_[static_cast<std::size_t>(face.neighbour) + 1];
    }
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    near_.resize(static_cast<std::size_t>(first_.back()));
    std::vector<Index> next = first_;
    for (const GridFace<D>& face : grid.faces) {
      if (face.neighbour == no_site) continue;
      const Vector<D> displacement = face.from_owner - face.from_neighbour;
      near_[static_cast<std::size_t>(next[static_cast<std::size_t>(face.owner)]++)] = {face.neighbour,
                                                                                       displacement};
      near_[static_cast<std::size_t>(next[static_cast<std::size_t>(face.neighbour)]++)] = {face.owner,
                                                                                           -displacement};
    }
  }

  /// Adds to `found` (whose first entry is the cell itself) the neighbours of its entries from `begin` on.
  void add_ring(std::vector<Near<D>>& found, std::size_t begin) const {
    const std::size_t end = found.size();
    for (std::size_t i = begin; i < end; ++i) {
      const Near<D> from = found[i];
      for (Index j = first_[static_cast<std::size_t>(from.cell)];
           j < first_[static_cast<std::size_t>(from.cell) + 1]; ++j) {
        const Near<D>& step = near_[static_cast<std::size_t>(j)];
        const Near<D> candidate{step.cell, from.displacement + step.displacement};
        if (!contains(found, candidate, step.displacement.norm())) found.push_back(candidate);
      }
    }
  }

 private:
  /// Images of one cell lie apart by whole periods, and two ways to one image by rounding only.
  static bool contains(const std::vector<Near<D>>& found, const Near<D>& candidate, double distance) {
    return std::any_of(found.begin(), found.end(), [&](const Near<D>& other) {
      return other.cell == candidate.cell &&
             (other.displacement - candidate.displacement).norm() < 1e-3 * distance;
    });
  }

  std::vector<Index> first_;
  std::vector<Near<D>> near_;
};

/// The normal matrix of the weighted least squares, from the cells after the first.  Eq. (T32)
template <int D>
Matrix<D> normal_matrix(const std::vector<Near<D>>& near) {
  Matrix<D> sum = Matrix<D>::Zero();
  for (std::size_t i = 1; i < near.size(); ++i) {
    const Vector<D> direction = near[i].displacement.normalized();
    sum += direction * direction.transpose();
  }
  return sum;
}

/// Eigenvalues of a symmetric matrix and its eigenvectors, in columns.
template <int D>
struct Spectrum {
  Vector<D> values;
  Matrix<D> vectors;

  [[nodiscard]] double smallest() const { return values.minCoeff(); }
};

/// By Jacobi's rotations, which square what is off the diagonal: eight rounds leave nothing of it.
template <int D>
Spectrum<D> spectrum_of(Matrix<D> a) {
  Matrix<D> vectors = Matrix<D>::Identity();
  for (int round = 0; round < 8; ++round) {
    for (int p = 0; p < D; ++p) {
      for (int q = p + 1; q < D; ++q) {
        const double angle = 0.5 * std::atan2(2 * a(p, q), a(q, q) - a(p, p));
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        Matrix<D> rotation = Matrix<D>::Identity();
        rotation(p, p) = c;
        rotation(q, q) = c;
        rotation(p, q) = s;
        rotation(q, p) = -s;
        a = rotation.transpose() * a * rotation;
        vectors = vectors * rotation;
      }
    }
  }
  return {a.diagonal(), vectors};
}

/// Of the normal matrix.
template <int D>
struct Solution {
  Matrix<D> inverse = Matrix<D>::Zero();  ///< zero along directions that are not seen
  Matrix<D> unseen = Matrix<D>::Zero();   ///< projects onto these
};

template <int D>
Solution<D> solution_of(const Spectrum<D>& spectrum) {
  Solution<D> solution;
  for (int d = 0; d < D; ++d) {
    const Matrix<D> onto = spectrum.vectors.col(d) * spectrum.vectors.col(d).transpose();
    if (spectrum.values[d] > seen) {
      solution.inverse += onto / spectrum.values[d];
    } else {
      solution.unseen += onto;
    }
  }
  return solution;
}

/// Adds the weights of the cells after the first, in single precision.
template <int D>
void add_weights(Stencils<D>& stencils, const std::vector<Near<D>>& near, const Matrix<D>& inverse,
                 double width) {
  for (std::size_t i = 1; i < near.size(); ++i) {
    const Vector<D>& d = near[i].displacement;
    const Vector<D> weight = inverse * d * (width / d.squaredNorm());
    StencilCell<D>& cell = stencils.cells.emplace_back();
    cell.cell = static_cast<std::int32_t>(near[i].cell);
    for (int k = 0; k < D; ++k) cell.weight[static_cast<std::size_t>(k)] = static_cast<float>(weight[k]);
  }
  stencils.first.push_back(static_cast<Index>(stencils.cells.size()));
}

/// What makes rounded weights exact for linear fields.  Eq. (T32a)
// Not inlined: with the rounding in sight GCC 12 (-O3) takes the weights as they were before it.
template <int D>
[[gnu::noinline]] Matrix<D> correction_of(std::span<const StencilCell<D>> cells,
                                          const std::vector<Near<D>>& near, const Matrix<D>& unseen,
                                          double width) {
  Matrix<D> sum = unseen;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    Vector<D> weight;
    for (int k = 0; k < D; ++k) weight[k] = static_cast<double>(cells[i].weight[static_cast<std::size_t>(k)]);
    sum += weight * near[i + 1].displacement.transpose() / width;
  }
  return sum.inverse() / width;
}

}  // namespace

template <int D>
Stencils<D> make_stencils(const GridParts<D>& grid, int rings) {
  const Neighbours<D> neighbours{grid};
  Stencils<D> stencils;
  stencils.first.push_back(0);
  std::vector<Near<D>> near;
  for (std::size_t cell = 0; cell < grid.volumes.size(); ++cell) {
    near.assign(1, {static_cast<Index>(cell), Vector<D>::Zero()});
    std::size_t begin = 0;
    Spectrum<D> spectrum;
    for (int ring = 1; ring <= most_rings; ++ring) {
      const std::size_t end = near.size();
      neighbours.add_ring(near, begin);
      begin = end;
      spectrum = spectrum_of<D>(normal_matrix<D>(near));
      if (ring >= rings && spectrum.smallest() >= well_seen) break;
    }
    const Solution<D> solution = solution_of<D>(spectrum);
    const double width = std::pow(grid.volumes[cell], 1.0 / D);
    add_weights<D>(stencils, near, solution.inverse, width);
    const auto weights = std::span{stencils.cells}.last(near.size() - 1);
    stencils.corrections.push_back(correction_of<D>(weights, near, solution.unseen, width));
  }
  return stencils;
}

template Stencils<1> make_stencils<1>(const GridParts<1>&, int);
template Stencils<2> make_stencils<2>(const GridParts<2>&, int);
template Stencils<3> make_stencils<3>(const GridParts<3>&, int);

}  // namespace scree::transport::detail
