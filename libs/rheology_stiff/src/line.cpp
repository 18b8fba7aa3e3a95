#include "preconditioner.hpp"

#include <Eigen/LU>

namespace scree::rheology::detail {

namespace {

/// Block elimination along the one axis: exact.  Eq. (R137)
template <int V>
class Line final : public Preconditioner<1, V> {
 public:
  explicit Line(const ViscousOperator<1, V>& viscous)
      : viscous_{viscous}, rows_(static_cast<std::size_t>(viscous.num_nodes())) {}

  void prepare(const ViscousMatrix& matrix) override {
    for (std::size_t node = 0; node < rows_.size(); ++node) {
      rows_[node] = {Block::Zero(), Block::Identity() * matrix.mass[node], Block::Zero()};
    }
    for (std::size_t cell = 0; cell + 1 < rows_.size(); ++cell) add(matrix, cell);
    for (std::size_t node = 0; node < rows_.size(); ++node) fix(matrix, node);
    for (std::size_t node = 0; node < rows_.size(); ++node) {
      Row& row = rows_[node];
      if (node > 0) row.diagonal -= row.below * rows_[node - 1].above;
      row.diagonal = row.diagonal.inverse().eval();
      row.above = row.diagonal * row.above;
    }
  }

  void solve(std::span<double> z) override {
    using Values = Eigen::Map<Vector<V>>;
    for (std::size_t node = 0; node < rows_.size(); ++node) {
      Values here{z.data() + node * V};
      if (node > 0) here -= rows_[node].below * Values{z.data() + (node - 1) * V};
      here = rows_[node].diagonal * here.eval();
    }
    for (std::size_t node = rows_.size() - 1; node-- > 0;) {
      Values{z.data() + node* V} -= rows_[node].above * Values{z.data() + (node + 1) * V};
    }
  }

 private:
  using Block = Matrix<V>;
  /// Before elimination the blocks themselves; after it the inverse of the pivot, and pivot^-1 above.
  struct Row {
    Block below;
    Block diagonal;
    Block above;
  };

  void add(const ViscousMatrix& matrix, std::size_t cell) {
    constexpr int size = CellStiffness<1, V>::size;
    Matrix<size> element = matrix.weights[cell] * viscous_.cell().matrix;
    if (!matrix.couplings.empty()) {
      using Element = Eigen::Matrix<double, size, 1, Eigen::DontAlign>;
      const Element pull =
          viscous_.cell().matrix * Eigen::Map<const Element>(matrix.velocity.data() + cell * V);
      element += matrix.couplings[cell] * pull * pull.transpose();
    }
    rows_[cell].diagonal += element.template topLeftCorner<V, V>();
    rows_[cell].above += element.template topRightCorner<V, V>();
    rows_[cell + 1].below += element.template bottomLeftCorner<V, V>();
    rows_[cell + 1].diagonal += element.template bottomRightCorner<V, V>();
  }

  /// What is fixed, and what nothing holds, keeps its value.
  void fix(const ViscousMatrix& matrix, std::size_t node) {
    Row& row = rows_[node];
    for (int i = 0; i < V; ++i) {
      const bool is_loose = row.diagonal(i, i) == 0;
      if (matrix.is_fixed[node * V + static_cast<std::size_t>(i)] == 0 && !is_loose) continue;
      for (Block* block : {&row.below, &row.diagonal, &row.above}) block->row(i).setZero();
      row.diagonal(i, i) = 1;
    }
  }

  const ViscousOperator<1, V>& viscous_;
  std::vector<Row> rows_;
};

}  // namespace

template <int V>
std::unique_ptr<Preconditioner<1, V>> make_line(const ViscousOperator<1, V>& viscous) {
  return std::make_unique<Line<V>>(viscous);
}

template std::unique_ptr<Preconditioner<1, 1>> make_line<1>(const ViscousOperator<1, 1>&);
template std::unique_ptr<Preconditioner<1, 2>> make_line<2>(const ViscousOperator<1, 2>&);
template std::unique_ptr<Preconditioner<1, 3>> make_line<3>(const ViscousOperator<1, 3>&);

}  // namespace scree::rheology::detail
