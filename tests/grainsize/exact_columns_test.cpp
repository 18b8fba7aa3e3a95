#include "column.hpp"
#include "exact_solutions.hpp"
#include "table.hpp"

#include <scree/grainsize/distribution.hpp>
#include <scree/grainsize/segregation.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace scree::grainsize {
namespace {

using test::Column;
using test::FrontColumn;
using test::HomogeneousColumn;
using test::InvertedColumn;
using test::read_table;

constexpr std::array<Index, 3> meshes{100, 200, 400};

template <class Start, class Exact>  // double(double z, std::size_t k): volume of class k below z
std::array<double, 3> errors(const SizeClasses& classes, double time, const Start& start,
                             const Exact& exact) {
  std::array<double, 3> result{};
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    Column column{classes, meshes[i]};
    column.set(start);
    column.advance(time);
    result[i] = column.error(exact);
  }
  return result;
}

/// Observed order over two doublings.
double order(const std::array<double, 3>& error) {
  return std::log2(error[0] / error[2]) / 2;
}

/// Classes of two: what lies below z of fines, and the rest.
template <class Below>
auto of_two(const Below& below) {
  return [below](double z, std::size_t k) { return k == 0 ? below(z) : z - below(z); };
}

TEST(ExactSolutions, AreThoseOfTheTables) {  // to the 1e-10 that the tables print
  for (const auto& row : read_table("segregation/bidisperse_profiles.csv")) {
    const double r = std::stod(row[1]);
    const double z = std::stod(row[4]);
    if (r == 1) continue;  // another flux
    const double time = std::stod(row[3]) / (r - 1);
    const HomogeneousColumn mixed{r, std::stod(row[2]), time};
    const InvertedColumn inverted{r, std::stod(row[2]), time};
    const bool is_mixed = row[0] == "homogeneous";
    const double base = is_mixed ? mixed.base_front() : inverted.base_front();
    const double top = is_mixed ? mixed.top_front() : inverted.top_front();
    if (std::min(std::abs(z - base), std::abs(z - top)) < 1e-9) continue;  // on a shock both sides are right

    EXPECT_NEAR(is_mixed ? mixed.fraction(z) : inverted.fraction(z), std::stod(row[5]), 1e-9)
        << row[0] << " r = " << r << " tau = " << row[3] << " z = " << z;
  }
}

// Between a shock's two sides the characteristic speeds differ by dlambda. Under the viscosity a dx/2 of the
// unlimited central flux its travelling wave is a tanh, and the L1 error |jump| 2 ln2 a dx/dlambda; a scheme
// with slopes must stay below (Eq. G19). It is first order. A shock that has not reached its steady width
// still spreads as the square root of time: then the order is between 1/2 and 1. Where in a cell it stands
// when it is sharper than one moves the observed order by up to 1/2. So what is asserted is the bound, and
// 1/2.

/// The characteristic speeds over B of a mixture, by the roots between neighbouring 1/s_k.  Eq. (G10)
std::vector<double> characteristics(const SizeClasses& classes, const std::vector<double>& phi) {
  const auto sizes = classes.diameters();
  const double s_h = harmonic_mean(sizes, phi);
  std::vector<double> speeds;
  for (std::size_t j = 0; j + 1 < classes.size(); ++j) {
    double low = 1 / sizes[j + 1];
    double high = 1 / sizes[j];
    for (int halving = 0; halving < 60; ++halving) {
      const double kappa = (low + high) / 2;
      double sum = 0;
      for (std::size_t k = 0; k < phi.size(); ++k) sum += phi[k] / sizes[k] / (kappa - 1 / sizes[k]);
      (sum > 0 ? low : high) = kappa;
    }
    speeds.push_back(1 - s_h * low);
  }
  return speeds;
}

/// Factor of dx in the L1 error of the shock between two states, from 2 ln2 a/dlambda of the family that runs
/// into it from both sides.
double shock_error(const SizeClasses& classes, const std::vector<double>& below,
                   const std::vector<double>& above) {
  const auto speeds_below = characteristics(classes, below);
  const auto speeds_above = characteristics(classes, above);
  double compression = 0;
  for (std::size_t j = 0; j < speeds_below.size(); ++j) {
    compression = std::max(compression, speeds_below[j] - speeds_above[j]);
  }
  double speed = 0;
  for (const auto& phi : {below, above}) {
    const double s_h = harmonic_mean(classes.diameters(), phi);
    speed = std::max({speed, s_h / classes.smallest() - 1, 1 - s_h / classes.largest()});
  }
  double jump = 0;
  for (std::size_t k = 0; k < below.size(); ++k) jump += std::abs(above[k] - below[k]);
  return jump * 2 * std::log(2.0) * speed / compression;
}

double error_bound(const SizeClasses& classes, const FrontColumn& exact, Index num_cells) {
  double factor = 0;
  for (std::size_t i = 0; i + 1 < exact.states.size(); ++i) {
    factor += shock_error(classes, exact.states[i], exact.states[i + 1]);
  }
  return factor / static_cast<double>(num_cells);
}

/// Fitted order of errors averaged over cases in which the shocks stand at different places in their cells.
class MeanOrder {
 public:
  void add(const std::array<double, 3>& error) {
    for (std::size_t i = 0; i < error.size(); ++i) log_sums_[i] += std::log2(error[i]);
    ++num_cases_;
  }
  [[nodiscard]] double value() const { return (log_sums_[0] - log_sums_[2]) / (2 * num_cases_); }

 private:
  std::array<double, 3> log_sums_{};
  int num_cases_ = 0;
};

TEST(TwoSizes, SettleFromAMixtureAsTheExactSolution) {
  MeanOrder mean_order;
  for (const double r : {2.0, 3.0}) {
    const SizeClasses classes{{1 / r, 1}};
    for (const double tau : {0.25, 0.5, 1.0, 1.25}) {
      const double time = tau / (r - 1);
      const HomogeneousColumn exact{r, 0.5, time};
      const FrontColumn fronts{{exact.base_front(), exact.top_front()}, {{1, 0}, {0.5, 0.5}, {0, 1}}};

      const auto error = errors(
          classes, time, [](double z, std::size_t) { return z / 2; },
          of_two([&](double z) { return exact.below(z); }));

      for (std::size_t i = 0; i < meshes.size(); ++i) {
        EXPECT_LE(error[i], error_bound(classes, fronts, meshes[i])) << "r = " << r << " tau = " << tau;
      }
      mean_order.add(error);
    }
  }
  EXPECT_GE(mean_order.value(), 0.8);  // 1, less what is left of the places in the cells
}

TEST(TwoSizes, OvertakeEachOtherAsTheExactSolution) {
  MeanOrder mean_order;
  for (const double r : {2.0, 3.0}) {
    const SizeClasses classes{{1 / r, 1}};
    // A fan that began as a jump keeps half a cell of it at each corner for two classes; shocks beside a fan
    // have at most the error of one between both pure states.
    const double factor = 2 + 2 * shock_error(classes, {1, 0}, {0, 1});
    for (const double tau : {0.25, 0.5, 1.0, 1.5, 2.0}) {
      const double time = tau / (r - 1);
      const InvertedColumn exact{r, 0.5, time};

      const auto error = errors(classes, time, of_two([](double z) { return std::max(0.0, z - 0.5); }),
                                of_two([&](double z) { return exact.below(z); }));

      for (std::size_t i = 0; i < meshes.size(); ++i) {
        EXPECT_LE(error[i], factor / static_cast<double>(meshes[i])) << "r = " << r << " tau = " << tau;
      }
      mean_order.add(error);
    }
  }
  EXPECT_GE(mean_order.value(), 0.8);
}

struct Mixture {
  std::string name;
  SizeClasses classes;
  std::vector<std::string> times;  ///< at which the table has a row between any two fronts
};

const std::vector<Mixture>& mixtures() {
  static const std::vector<Mixture> all{
      {"3bin", SizeClasses{{0.5, 0.75, 1}}, {"0.2821367205", "1.410683603", "2.116025404", "2.680298845"}},
      {"5bin",
       SizeClasses{{0.2, 0.4, 0.6, 0.8, 1}},
       {"0.2612408433", "1.306204216", "1.959306325", "2.481788011"}}};
  return all;
}

TEST(SeveralSizes, SettleAsTheExactSolution) {
  for (const auto& [name, classes, times] : mixtures()) {
    const auto n = static_cast<double>(classes.size());
    for (const std::string& time : times) {
      const FrontColumn exact = test::read_front_column(name, time);

      const auto error = errors(
          classes, std::stod(time), [n](double z, std::size_t) { return z / n; },
          [&](double z, std::size_t k) { return exact.below(z, k); });

      EXPECT_LE(error[2], error_bound(classes, exact, 400)) << name << " at " << time;
      EXPECT_GE(order(error), 0.5) << name << " at " << time;
    }
  }
}

/// sum_k integral |Phi_k - segregated| of the exact solution is not zero before the time of full segregation,
/// and that of the scheme is at most the shock's bound after it.
TEST(TwoSizes, AreFullySegregatedAtTheTabulatedTime) {
  constexpr Index num_cells = 200;
  for (const auto& row : read_table("segregation/bidisperse_full_segregation_times.csv")) {
    const double r = std::stod(row[1]);
    const double fines = std::stod(row[2]);
    if (r == 1) continue;
    const SizeClasses classes{{1 / r, 1}};
    const bool is_mixed = row[0] == "homogeneous";
    const double end = std::stod(row[4]);
    const auto segregated = of_two([fines](double z) { return std::min(z, fines); });
    Column column{classes, num_cells};
    column.set(of_two([&](double z) { return is_mixed ? fines * z : std::max(0.0, z - (1 - fines)); }));

    column.advance(0.9 * end);
    const double before = column.error(segregated);
    column.advance(0.1 * end);
    const double after = column.error(segregated);

    const double bound = shock_error(classes, {1, 0}, {0, 1}) / num_cells;
    const HomogeneousColumn mixed{r, fines, 0.9 * end};
    const InvertedColumn inverted{r, fines, 0.9 * end};
    const double exact_before = 4 * (fines - (is_mixed ? mixed.below(fines) : inverted.below(fines)));
    EXPECT_NEAR(before, exact_before, 2 * bound + 2.0 / num_cells) << row[0] << " r = " << r << " " << fines;
    EXPECT_LE(after, bound + 2.0 / num_cells) << row[0] << " r = " << r << " " << fines;
  }
}

TEST(SeveralSizes, AreFullySegregatedAtTheTabulatedTime) {
  constexpr Index num_cells = 200;
  for (const auto& row : read_table("segregation/polydisperse_times.csv")) {
    const auto mixture = std::find_if(mixtures().begin(), mixtures().end(),
                                      [&](const Mixture& m) { return m.name == row[0]; });
    if (mixture == mixtures().end()) continue;
    const double share = 1 / static_cast<double>(mixture->classes.size());
    const double end = std::stod(row[row.size() - 2]);
    FrontColumn segregated;
    for (std::size_t k = 0; k < mixture->classes.size(); ++k) {
      if (k > 0) segregated.fronts.push_back(static_cast<double>(k) * share);
      segregated.states.emplace_back(mixture->classes.size(), 0.0);
      segregated.states.back()[k] = 1;
    }
    Column column{mixture->classes, num_cells};
    column.set([share](double z, std::size_t) { return share * z; });

    column.advance(end);

    EXPECT_LE(column.error([&](double z, std::size_t k) { return segregated.below(z, k); }),
              error_bound(mixture->classes, segregated, num_cells))
        << mixture->name;
  }
}

TEST(Remixing, BalancesSegregationInTheSteadyProfileToSecondOrder) {  // Eq. (G5)
  for (const std::string peclet : {"2", "5", "10"}) {
    std::array<double, 2> error{};
    const std::array<Index, 2> num_cells{25, 75};  // the table's odd heights are centres of cells of both
    for (std::size_t i = 0; i < 2; ++i) {
      SegregationOptions options = Column::defaults();
      options.remixing = 1 / std::stod(peclet);
      Column column{SizeClasses{{0.5, 1}}, num_cells[i], options};
      column.set([](double z, std::size_t) { return z / 2; });
      column.advance(10);  // the slowest mode decays as exp(-(pi^2 D + W^2/4 D) t) or faster: by 1e-12

      double largest = 0;
      for (const auto& row : read_table("segregation/steady_remixing_profiles.csv")) {
        if (row[0] != "harmonic 2bin_r2 WH/D=" + peclet) continue;
        const double cell = std::stod(row[1]) * static_cast<double>(num_cells[i]) - 0.5;
        if (std::abs(cell - std::round(cell)) > 1e-6) continue;
        const double phi = column.fraction(static_cast<std::size_t>(std::lround(cell)), 0);
        largest = std::max(largest, std::abs(phi - std::stod(row[3])));
      }
      error[i] = largest;
    }
    const double observed = std::log(error[0] / error[1]) / std::log(3.0);
    EXPECT_GE(observed, 1.8) << "W H/D = " << peclet;
  }
}

}  // namespace
}  // namespace scree::grainsize
