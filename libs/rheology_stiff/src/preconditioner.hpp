#pragma once

#include <scree/rheology_stiff/implicit_viscosity.hpp>

#include <memory>
#include <span>

namespace scree::rheology::detail {

/// The matrix of one Newton step, m + K with the step's length in the weights of cells.  Eq. (R134)
struct ViscousMatrix {
  std::span<const double> mass;            ///< of each node [kg]
  std::span<const double> weights;         ///< of each cell [kg/s m^2]
  std::span<const double> couplings;       ///< of each cell; none if viscosity does not depend on velocity
  std::span<const double> velocity;        ///< where it was linearised, num_nodes x V
  std::span<const std::uint8_t> is_fixed;  ///< num_nodes x V: not solved for
};

/// Solves with a matrix nearly, in place; a symmetric and positive map, which leaves zero what is fixed.
template <int D, int V>
class Preconditioner {
 public:
  Preconditioner() = default;
  Preconditioner(const Preconditioner&) = delete;
  Preconditioner& operator=(const Preconditioner&) = delete;
  virtual ~Preconditioner() = default;

  /// The matrix stays where it is until the next call.
  virtual void prepare(const ViscousMatrix& matrix) = 0;
  virtual void solve(std::span<double> z) = 0;
  /// Whether `solve` leaves nothing but round-off.
  [[nodiscard]] virtual bool is_exact() const noexcept { return false; }
  /// Products with the operator that one `solve` takes, in those of the finest grid [-].
  [[nodiscard]] virtual double products() const noexcept { return 0; }
};

template <int D, int V>
[[nodiscard]] std::unique_ptr<Preconditioner<D, V>> make_jacobi(const ViscousOperator<D, V>& viscous);
template <int V>
[[nodiscard]] std::unique_ptr<Preconditioner<1, V>> make_line(const ViscousOperator<1, V>& viscous);
template <int D, int V>
[[nodiscard]] std::unique_ptr<Preconditioner<D, V>> make_multigrid(const ViscousOperator<D, V>& viscous);

/// 1/(m + K) of the diagonal; 0 for what is fixed and for nodes that nothing holds.
template <int D, int V>
void invert_diagonal(const ViscousOperator<D, V>& viscous, const ViscousMatrix& matrix,
                     std::span<double> inverse) {
  viscous.diagonal(matrix.weights, inverse);
  for (std::size_t i = 0; i < inverse.size(); ++i) {
    const double diagonal = matrix.mass[i / V] + inverse[i];
    inverse[i] = matrix.is_fixed[i] != 0 || diagonal == 0 ? 0 : 1 / diagonal;
  }
}

}  // namespace scree::rheology::detail
