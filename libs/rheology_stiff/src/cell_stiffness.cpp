#include "instances.hpp"

#include <scree/rheology_stiff/cell_stiffness.hpp>

#include <Eigen/Eigenvalues>
#include <array>
#include <numbers>
#include <vector>

namespace scree::rheology {

namespace {

/// Deviatoric rate of deformation at `point` of the unit cell when one component of one corner moves at
/// 1 m/s [1/m].
template <int D>
Tensor<double> rate_of(const Vector<D>& spacing, const Vector<D>& point, int corner, int component) {
  Tensor<double> gradient;
  for (int axis = 0; axis < D; ++axis) {
    double slope = ((corner >> axis) & 1) == 1 ? 1 / spacing[axis] : -1 / spacing[axis];
    for (int other = 0; other < D; ++other) {
      if (other != axis) slope *= ((corner >> other) & 1) == 1 ? point[other] : 1 - point[other];
    }
    gradient(static_cast<std::size_t>(component), static_cast<std::size_t>(axis)) = slope;
  }
  return deviator(symmetric_part(gradient));
}

template <int D>
std::vector<Vector<D>> points_of(Quadrature quadrature) {
  if (quadrature == Quadrature::centre) return {Vector<D>::Constant(0.5)};
  std::vector<Vector<D>> points;
  for (int n = 0; n < 1 << D; ++n) {
    Vector<D> point;
    for (int axis = 0; axis < D; ++axis) {
      point[axis] = 0.5 + (((n >> axis) & 1) == 1 ? 0.5 : -0.5) / std::numbers::sqrt3;
    }
    points.push_back(point);
  }
  return points;
}

}  // namespace

template <int D, int V>
CellStiffness<D, V> make_cell_stiffness(const Vector<D>& spacing, Quadrature quadrature) {
  constexpr int size = CellStiffness<D, V>::size;
  CellStiffness<D, V> cell{Matrix<size>::Zero(), 0, 0};
  const auto points = points_of<D>(quadrature);
  for (const Vector<D>& point : points) {
    std::array<Tensor<double>, static_cast<std::size_t>(size)> rates;
    for (int n = 0; n < size; ++n) {
      rates[static_cast<std::size_t>(n)] = rate_of<D>(spacing, point, n / V, n % V);
    }
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        cell.matrix(row, column) +=
            2 * contract(rates[static_cast<std::size_t>(row)], rates[static_cast<std::size_t>(column)]) /
            static_cast<double>(points.size());
      }
    }
  }
  using Solver = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>;
  const Eigen::MatrixXd matrix = cell.matrix;
  const Eigen::VectorXd scale = matrix.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * matrix * scale.asDiagonal();
  cell.largest_eigenvalue = Solver{matrix, Eigen::EigenvaluesOnly}.eigenvalues().maxCoeff();
  cell.largest_ratio = Solver{scaled, Eigen::EigenvaluesOnly}.eigenvalues().maxCoeff();
  return cell;
}

#define SCREE_INSTANCE(D, V) \
  template CellStiffness<D, V> make_cell_stiffness<D, V>(const Vector<D>&, Quadrature);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::rheology
