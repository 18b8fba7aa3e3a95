#include "coarsening.hpp"
#include "instances.hpp"
#include "preconditioner.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

namespace scree::rheology::detail {

namespace {

/// One grid of a multigrid cycle, and what is kept on it.
template <int D, int V>
struct Level {
  explicit Level(ViscousOperator<D, V> viscous_)
      : viscous{std::move(viscous_)},
        mass(static_cast<std::size_t>(viscous.num_nodes()), 0.0),
        weights(static_cast<std::size_t>(viscous.num_cells()), 0.0),
        is_fixed(viscous.num_values(), 0),
        inverse_diagonal(viscous.num_values(), 0.0),
        right(viscous.num_values(), 0.0),
        z(viscous.num_values(), 0.0),
        step(viscous.num_values(), 0.0),
        product(viscous.num_values(), 0.0) {}

  [[nodiscard]] ViscousMatrix matrix() const noexcept { return {mass, weights, {}, {}, is_fixed}; }

  ViscousOperator<D, V> viscous;
  std::vector<double> mass;
  std::vector<double> weights;
  std::vector<std::uint8_t> is_fixed;
  std::vector<double> inverse_diagonal;
  std::vector<double> right;  // what is left of the right side
  std::vector<double> z;
  std::vector<double> step;
  std::vector<double> product;
};

/// One V-cycle from zero.  Eqs. (R138), (R139)
template <int D, int V>
class Multigrid final : public Preconditioner<D, V> {
 public:
  explicit Multigrid(const ViscousOperator<D, V>& viscous) {
    levels_.emplace_back(viscous);
    while (const auto coarse = Coarsening<D>::coarser(levels_.back().viscous.grid())) {
      coarsenings_.emplace_back(levels_.back().viscous.grid(), *coarse);
      levels_.emplace_back(ViscousOperator<D, V>{*coarse, Quadrature::gauss, viscous.threads()});
    }
    const auto size = static_cast<Index>(levels_.back().viscous.num_values());
    if (size <= largest_direct) coarsest_.setZero(size, size);
  }

  void prepare(const ViscousMatrix& matrix) override {
    Level<D, V>& finest = levels_.front();
    std::ranges::copy(matrix.mass, finest.mass.begin());
    std::ranges::copy(matrix.weights, finest.weights.begin());
    std::ranges::copy(matrix.is_fixed, finest.is_fixed.begin());
    for (std::size_t l = 0; l + 1 < levels_.size(); ++l) coarsen(l);
    for (Level<D, V>& level : levels_) {
      invert_diagonal(level.viscous, level.matrix(), level.inverse_diagonal);
    }
    if (coarsest_.size() > 0) factor(levels_.back());
  }

  void solve(std::span<double> z) override {
    std::ranges::copy(z, levels_.front().right.begin());
    cycle(0);
    std::ranges::copy(levels_.front().z, z.begin());
  }

  [[nodiscard]] double products() const noexcept override {
    double sum = 0;
    for (const Level<D, V>& level : levels_) {
      sum += (2 * degree + 1) * static_cast<double>(level.z.size()) /
             static_cast<double>(levels_.front().z.size());
    }
    return sum;
  }

 private:
  static constexpr int degree = 3;              // of the polynomials that smooth
  static constexpr double smoothed_part = 6;    // [-] rates within this factor of the largest are smoothed
  static constexpr Index largest_direct = 512;  // unknowns that are solved for directly
  static constexpr int degree_of_coarsest = 16;
  static constexpr double part_of_coarsest = 100;

  void coarsen(std::size_t l) {
    const Level<D, V>& fine = levels_[l];
    Level<D, V>& coarse = levels_[l + 1];
    const Coarsening<D>& between = coarsenings_[l];
    std::ranges::fill(coarse.mass, 0.0);
    between.template restrict_to<1>(coarse.mass, fine.mass);
    between.sum_cells(coarse.weights, fine.weights);
    for (Index node = 0; node < coarse.viscous.num_nodes(); ++node) {
      const auto from = static_cast<std::size_t>(between.heir(node) * V);
      std::copy_n(fine.is_fixed.begin() + static_cast<Index>(from), V, coarse.is_fixed.begin() + node * V);
    }
  }

  void cycle(std::size_t l) {
    Level<D, V>& level = levels_[l];
    std::ranges::fill(level.z, 0.0);
    if (l + 1 == levels_.size()) return solve_coarsest(level);
    smooth(level, degree, smoothed_part);
    Level<D, V>& coarse = levels_[l + 1];
    for (std::size_t i = 0; i < level.right.size(); ++i) {
      level.product[i] = level.inverse_diagonal[i] != 0 ? level.right[i] : 0;
    }
    std::ranges::fill(coarse.right, 0.0);
    coarsenings_[l].template restrict_to<V>(coarse.right, level.product);
    cycle(l + 1);
    std::ranges::fill(level.step, 0.0);
    coarsenings_[l].template interpolate<V>(level.step, level.inverse_diagonal, coarse.z);
    advance(level);
    smooth(level, degree, smoothed_part);
  }

  /// z += step, and `right` is what is left then.
  static void advance(Level<D, V>& level) noexcept {
    level.viscous.apply(level.mass, level.weights, level.step, level.product);
    for (std::size_t i = 0; i < level.z.size(); ++i) {
      level.z[i] += level.step[i];
      level.right[i] -= level.product[i];
    }
  }

  /// Chebyshev's iteration for rates of the diagonally scaled matrix between the largest and `part` of it.
  /// The largest is known: it is that of one cell.  Eq. (R139)
  static void smooth(Level<D, V>& level, int num_steps, double part) noexcept {
    const double largest = level.viscous.cell().largest_ratio;
    const double middle = (largest + largest / part) / 2;
    const double half_width = (largest - largest / part) / 2;
    double ratio = half_width / middle;
    for (std::size_t i = 0; i < level.z.size(); ++i) {
      level.step[i] = level.inverse_diagonal[i] * level.right[i] / middle;
    }
    advance(level);
    for (int n = 1; n < num_steps; ++n) {
      const double next = 1 / (2 * middle / half_width - ratio);
      for (std::size_t i = 0; i < level.z.size(); ++i) {
        level.step[i] =
            next * ratio * level.step[i] + 2 * next / half_width * level.inverse_diagonal[i] * level.right[i];
      }
      ratio = next;
      advance(level);
    }
  }

  /// The coarsest matrix, dense; what is fixed is left alone.
  void factor(const Level<D, V>& level) {
    coarsest_.setZero();
    constexpr int num_corners = CellStiffness<D, V>::num_corners;
    const auto& cell_matrix = level.viscous.cell().matrix;
    for (Index cell = 0; cell < level.viscous.num_cells(); ++cell) {
      const auto nodes = level.viscous.corners(cell);
      const double weight = level.weights[static_cast<std::size_t>(cell)];
      for (int a = 0; a < num_corners; ++a) {
        for (int b = 0; b < num_corners; ++b) {
          coarsest_.template block<V, V>(nodes[static_cast<std::size_t>(a)] * V,
                                         nodes[static_cast<std::size_t>(b)] * V) +=
              weight * cell_matrix.template block<V, V>(a * V, b * V);
        }
      }
    }
    // Massless nodes that only a rotation moves: what makes the matrix positive there too is far below what
    // any right side asks.
    constexpr double lift = 1 + 1e-12;  // [-]
    for (Index i = 0; i < coarsest_.rows(); ++i) {
      const auto n = static_cast<std::size_t>(i);
      coarsest_(i, i) = (coarsest_(i, i) + level.mass[n / V]) * lift;
      if (level.inverse_diagonal[n] != 0) continue;
      coarsest_.row(i).setZero();
      coarsest_.col(i).setZero();
      coarsest_(i, i) = 1;
    }
    factors_.compute(coarsest_);
  }

  void solve_coarsest(Level<D, V>& level) {
    if (coarsest_.size() == 0) return smooth(level, degree_of_coarsest, part_of_coarsest);
    Eigen::Map<Eigen::VectorXd> z{level.z.data(), static_cast<Index>(level.z.size())};
    for (std::size_t i = 0; i < level.z.size(); ++i) {
      level.z[i] = level.inverse_diagonal[i] != 0 ? level.right[i] : 0;
    }
    factors_.solveInPlace(z);
  }

  std::vector<Level<D, V>> levels_;
  std::vector<Coarsening<D>> coarsenings_;
  Eigen::MatrixXd coarsest_;
  Eigen::LLT<Eigen::MatrixXd> factors_;
};

}  // namespace

template <int D, int V>
std::unique_ptr<Preconditioner<D, V>> make_multigrid(const ViscousOperator<D, V>& viscous) {
  return std::make_unique<Multigrid<D, V>>(viscous);
}

// NOLINTBEGIN(bugprone-macro-parentheses): D and V are template arguments
#define SCREE_INSTANCE(D, V) \
  template std::unique_ptr<Preconditioner<D, V>> make_multigrid<D, V>(const ViscousOperator<D, V>&);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE
// NOLINTEND(bugprone-macro-parentheses)

}  // namespace scree::rheology::detail
