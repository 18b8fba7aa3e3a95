#include "instances.hpp"
#include "preconditioner.hpp"

namespace scree::rheology::detail {

namespace {

template <int D, int V>
class Jacobi final : public Preconditioner<D, V> {
 public:
  explicit Jacobi(const ViscousOperator<D, V>& viscous)
      : viscous_{viscous}, inverse_(viscous.num_values(), 0.0) {}

  void prepare(const ViscousMatrix& matrix) override { invert_diagonal(viscous_, matrix, inverse_); }
  void solve(std::span<double> z) override {
    for (std::size_t i = 0; i < z.size(); ++i) z[i] *= inverse_[i];
  }

 private:
  const ViscousOperator<D, V>& viscous_;
  std::vector<double> inverse_;
};

}  // namespace

template <int D, int V>
std::unique_ptr<Preconditioner<D, V>> make_jacobi(const ViscousOperator<D, V>& viscous) {
  return std::make_unique<Jacobi<D, V>>(viscous);
}

// NOLINTBEGIN(bugprone-macro-parentheses): D and V are template arguments
#define SCREE_INSTANCE(D, V) \
  template std::unique_ptr<Preconditioner<D, V>> make_jacobi<D, V>(const ViscousOperator<D, V>&);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE
// NOLINTEND(bugprone-macro-parentheses)

}  // namespace scree::rheology::detail
