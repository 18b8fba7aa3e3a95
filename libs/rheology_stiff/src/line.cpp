#include "preconditioner.hpp"

#include <Eigen/LU>

namespace scree::rheology::detail {

namespace {

/// V x V blocks that are diagonal: components that nothing ties to each other.
template <int V>
using Apart = Eigen::Array<double, V, 1, Eigen::DontAlign>;

template <int V>
[[nodiscard]] Matrix<V> inverse(const Matrix<V>& block) noexcept {
  return block.inverse();
}
template <int V>
[[nodiscard]] Apart<V> inverse(const Apart<V>& block) noexcept {
  return block.inverse();
}
template <int V>
[[nodiscard]] Vector<V> product(const Matrix<V>& block, const Vector<V>& values) noexcept {
  return block * values;
}
template <int V>
[[nodiscard]] Vector<V> product(const Apart<V>& block, const Vector<V>& values) noexcept {
  return block * values.array();
}

/// Three diagonals of blocks. Before elimination they are the matrix; after it `diagonal` is the inverse of
/// the pivot, and `above` is that times the block above.  Eq. (R137)
template <int V, class Block>
class Elimination {
 public:
  struct Row {
    Block below;
    Block diagonal;
    Block above;
  };

  explicit Elimination(std::size_t num_nodes) : rows_(num_nodes) {}

  [[nodiscard]] std::vector<Row>& rows() noexcept { return rows_; }

  void eliminate() noexcept {
    for (std::size_t node = 0; node < rows_.size(); ++node) {
      Row& row = rows_[node];
      if (node > 0) row.diagonal -= row.below * rows_[node - 1].above;
      row.diagonal = inverse<V>(row.diagonal);
      row.above = (row.diagonal * row.above).eval();
    }
  }

  void solve(std::span<double> z) const noexcept {
    using Values = Eigen::Map<Vector<V>>;
    Vector<V> last = Vector<V>::Zero();
    for (std::size_t node = 0; node < rows_.size(); ++node) {
      Values here{z.data() + node * V};
      const Vector<V> rest = node > 0 ? Vector<V>{here - product<V>(rows_[node].below, last)} : here;
      last = product<V>(rows_[node].diagonal, rest);
      here = last;
    }
    for (std::size_t node = rows_.size() - 1; node-- > 0;) {
      Values here{z.data() + node * V};
      last = here - product<V>(rows_[node].above, last);
      here = last;
    }
  }

 private:
  std::vector<Row> rows_;
};

/// Block elimination along the one axis: exact. Only a viscosity that depends on the velocity ties the
/// components to each other.
template <int V>
class Line final : public Preconditioner<1, V> {
 public:
  explicit Line(const ViscousOperator<1, V>& viscous)
      : viscous_{viscous},
        apart_{static_cast<std::size_t>(viscous.num_nodes())},
        tied_{static_cast<std::size_t>(viscous.num_nodes())} {}

  [[nodiscard]] bool is_exact() const noexcept override { return true; }

  void prepare(const ViscousMatrix& matrix) override {
    is_tied_ = !matrix.couplings.empty();
    if (is_tied_) {
      assemble(matrix, tied_.rows());
      tied_.eliminate();
    } else {
      assemble(matrix, apart_.rows());
      apart_.eliminate();
    }
  }

  void solve(std::span<double> z) override {
    if (is_tied_) {
      tied_.solve(z);
    } else {
      apart_.solve(z);
    }
  }

 private:
  using Tied = Elimination<V, Matrix<V>>;
  using Free = Elimination<V, Apart<V>>;
  using Corner = Matrix<V>;

  void assemble(const ViscousMatrix& matrix, std::vector<typename Tied::Row>& rows) const {
    for (std::size_t node = 0; node < rows.size(); ++node) {
      rows[node] = {Corner::Zero(), Corner::Identity() * matrix.mass[node], Corner::Zero()};
    }
    constexpr int size = CellStiffness<1, V>::size;
    for (std::size_t cell = 0; cell + 1 < rows.size(); ++cell) {
      using Element = Eigen::Matrix<double, size, 1, Eigen::DontAlign>;
      const Element pull =
          viscous_.cell().matrix * Eigen::Map<const Element>(matrix.velocity.data() + cell * V);
      const Matrix<size> element =
          matrix.weights[cell] * viscous_.cell().matrix + matrix.couplings[cell] * pull * pull.transpose();
      rows[cell].diagonal += element.template topLeftCorner<V, V>();
      rows[cell].above += element.template topRightCorner<V, V>();
      rows[cell + 1].below += element.template bottomLeftCorner<V, V>();
      rows[cell + 1].diagonal += element.template bottomRightCorner<V, V>();
    }
    for (std::size_t node = 0; node < rows.size(); ++node) {
      for (int i = 0; i < V; ++i) {
        auto& [below, diagonal, above] = rows[node];
        if (!stays(matrix, node, i, diagonal(i, i))) continue;
        for (Corner* block : {&below, &diagonal, &above}) block->row(i).setZero();
        diagonal(i, i) = 1;
      }
    }
  }

  void assemble(const ViscousMatrix& matrix, std::vector<typename Free::Row>& rows) const {
    const Apart<V> cell = viscous_.cell().matrix.diagonal().template head<V>();  // minus that beside it
    double below = 0;
    for (std::size_t node = 0; node < rows.size(); ++node) {
      const double above = node + 1 < rows.size() ? matrix.weights[node] : 0;
      auto& row = rows[node];
      row = {-below * cell, matrix.mass[node] + (below + above) * cell, -above * cell};
      for (int i = 0; i < V; ++i) {
        if (!stays(matrix, node, i, row.diagonal[i])) continue;
        row.below[i] = row.above[i] = 0;
        row.diagonal[i] = 1;
      }
      below = above;
    }
  }

  /// What is fixed, and what nothing holds, keeps its value.
  [[nodiscard]] static bool stays(const ViscousMatrix& matrix, std::size_t node, int i,
                                  double diagonal) noexcept {
    return matrix.is_fixed[node * V + static_cast<std::size_t>(i)] != 0 || diagonal == 0;
  }

  const ViscousOperator<1, V>& viscous_;
  Free apart_;
  Tied tied_;
  bool is_tied_ = false;
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
