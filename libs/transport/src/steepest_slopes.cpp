#include <scree/transport/detail/steepest_slopes.hpp>

#include <cmath>
#include <vector>

namespace scree::transport::detail {
namespace {

/// Coefficients, that of u^k at [k].
using Polynomial = std::vector<double>;

double value(const Polynomial& p, double u) {
  double result = 0;
  for (std::size_t k = p.size(); k-- > 0;) result = result * u + p[k];
  return result;
}

Polynomial derivative(const Polynomial& p) {
  Polynomial result;
  for (std::size_t k = 1; k < p.size(); ++k) result.push_back(static_cast<double>(k) * p[k]);
  return result;
}

Polynomial product(const Polynomial& p, const Polynomial& q) {
  Polynomial result(p.size() + q.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < q.size(); ++j) result[i + j] += p[i] * q[j];
  }
  return result;
}

/// p - factor q, with as many coefficients as the longer one.
Polynomial difference(Polynomial p, double factor, const Polynomial& q) {
  if (p.size() < q.size()) p.resize(q.size());
  for (std::size_t k = 0; k < q.size(); ++k) p[k] -= factor * q[k];
  return p;
}

/// The root of a polynomial that is monotone between two points and changes sign there, halving until no
/// double lies between.
double bisect(const Polynomial& p, double low, double high) {
  const bool rises = value(p, high) > 0;
  for (;;) {
    const double middle = 0.5 * (low + high);
    if (!(low < middle && middle < high)) return middle;
    (((value(p, middle) > 0) == rises) ? high : low) = middle;
  }
}

/// The roots of a polynomial between 0 and 1: one at most between two roots of its derivative.
std::vector<double> roots(const Polynomial& p) {
  if (p.size() < 2) return {};
  std::vector<double> ends = roots(derivative(p));
  ends.push_back(1);
  std::vector<double> result;
  double low = 0;
  for (const double high : ends) {
    if ((value(p, low) > 0) != (value(p, high) > 0)) result.push_back(bisect(p, low, high));
    low = high;
  }
  return result;
}

}  // namespace

SteepestSlopes steepest_slopes_of_fractional_flow(double gravity, double viscosity_ratio) {
  const Polynomial wet{0, 0, 1};
  const Polynomial dry{1, -2, 1};
  const Polynomial numerator = difference(wet, gravity, product(wet, dry));
  const Polynomial total = difference(wet, -viscosity_ratio, dry);
  const Polynomial slope =  // f' = slope / total^2
      difference(product(derivative(numerator), total), 1, product(numerator, derivative(total)));
  const Polynomial curvature =  // f'' = curvature / total^3
      difference(product(derivative(slope), total), 2, product(slope, derivative(total)));
  SteepestSlopes result;
  std::size_t count = 0;
  for (const double u : roots(curvature)) {
    if (count == SteepestSlopes::max_count) break;
    result.at[count] = u;
    result.slope[count] = value(slope, u) / (value(total, u) * value(total, u));
    ++count;
  }
  return result;
}

}  // namespace scree::transport::detail
