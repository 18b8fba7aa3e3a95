#include <scree/error.hpp>
#include <scree/rheology_stiff/rkl2.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace scree::rheology {

namespace {

template <class... Part>
[[noreturn]] void refuse_stages(const Part&... part) {
  std::ostringstream text;
  (text << ... << part);
  throw InputError{text.str()};
}

/// b_j of Eq. (R141).
double coefficient(int j) noexcept {
  if (j < 2) return 1.0 / 3;
  return (j * j + j - 2.0) / (2.0 * j * (j + 1));
}

}  // namespace

int rkl2_stages(double step, double explicit_step) {
  if (!(step >= 0 && std::isfinite(step))) {
    refuse_stages("rkl2_stages: the step is ", step, " s: must be zero or positive, and finite");
  }
  if (!(explicit_step > 0)) {
    refuse_stages("rkl2_stages: the explicit step is ", explicit_step, " s: must be positive");
  }
  const double ratio = step / explicit_step;  // (s^2 + s - 2)/4 at least
  const double fewest = (std::sqrt(9 + 16 * ratio) - 1) / 2;
  if (!(fewest <= largest_rkl2)) {
    refuse_stages("rkl2_stages: a step of ", step, " s takes ", fewest, " stages: must be ", largest_rkl2,
                  " or fewer");
  }
  const int stages = std::max(3, static_cast<int>(std::ceil(fewest)));
  return stages % 2 == 0 ? stages + 1 : stages;
}

Rkl2::Rkl2(std::size_t num_values)
    : start_(num_values, 0.0),
      first_rate_(num_values, 0.0),
      rate_(num_values, 0.0),
      before_last_(num_values, 0.0),
      last_(num_values, 0.0) {}

void Rkl2::advance(std::span<double> u, double step, int stages, const Rate& rate) {
  if (u.size() != start_.size()) refuse_stages("Rkl2: ", u.size(), " values: must be ", start_.size());
  if (stages < 2) refuse_stages("Rkl2: ", stages, " stages: must be 2 or more");
  const double w = 4 / (static_cast<double>(stages) * stages + stages - 2);
  std::ranges::copy(u, start_.begin());
  std::ranges::copy(u, before_last_.begin());
  rate(start_, first_rate_);
  for (std::size_t i = 0; i < u.size(); ++i) {
    last_[i] = start_[i] + w * coefficient(1) * step * first_rate_[i];
  }
  for (int j = 2; j <= stages; ++j) {
    const double share = coefficient(j);
    const double mu = (2.0 * j - 1) / j * share / coefficient(j - 1);
    const double nu = -(j - 1.0) / j * share / coefficient(j - 2);
    const double gamma = -(1 - coefficient(j - 1)) * mu * w;
    rate(last_, rate_);
    for (std::size_t i = 0; i < u.size(); ++i) {
      before_last_[i] = mu * last_[i] + nu * before_last_[i] + (1 - mu - nu) * start_[i] +
                        step * (mu * w * rate_[i] + gamma * first_rate_[i]);
    }
    std::swap(before_last_, last_);
  }
  std::ranges::copy(last_, u.begin());
}

}  // namespace scree::rheology
