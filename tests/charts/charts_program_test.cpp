// The program behind the charts as people run it: what it writes, and what it says when it cannot.

#include "run_program.hpp"

#include <scree/transport/fluxes.hpp>
#include <scree/transport/integrators.hpp>
#include <scree/transport/limiters.hpp>
#include <scree/transport/type_list.hpp>

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace scree::charts {
namespace {

using Result = testing::ProgramResult;

Result scree_charts(const std::string& arguments) {
  return testing::run_program(SCREE_CHARTS, arguments);
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream text{line};
  for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
  return cells;
}

/// A quick run of three problems: a scalar, a system, fractions.
class QuickTable : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    // Each test may run in a process of its own, side by side with the others.
    const std::string file = ::testing::TempDir() + "scree_charts_" + std::to_string(getpid()) + ".csv";
    run_ =
        scree_charts("--quick --problem advection --problem sod --problem segregation_two_sizes -o " + file);
    std::ifstream text{file};
    std::getline(text, header_);
    for (std::string line; std::getline(text, line);) rows_.push_back(cells_of(line));
    std::remove(file.c_str());
  }
  static std::set<std::string> column(std::size_t number) {
    std::set<std::string> values;
    for (const auto& row : rows_) values.insert(row.at(number));
    return values;
  }

  static inline Result run_;
  static inline std::string header_;
  static inline std::vector<std::vector<std::string>> rows_;
};

TEST_F(QuickTable, HasItsHeader) {
  EXPECT_EQ(run_.exit_code, 0) << run_.output;
  EXPECT_EQ(header_, "problem,scheme,flux,limiter,integrator,n,cfl,steps,flux_evaluations,cpu_seconds,l1");
}

TEST_F(QuickTable, HasFinitePositiveNumbers) {
  ASSERT_FALSE(rows_.empty());
  for (const auto& row : rows_) {
    ASSERT_EQ(row.size(), 11U);
    for (std::size_t number = 5; number < row.size(); ++number) {
      if (number == 9) continue;  // a run may be shorter than a tick of the clock
      EXPECT_GT(std::stod(row[number]), 0) << row[0] << " " << row[1] << " " << row[3];
      EXPECT_TRUE(std::isfinite(std::stod(row[number]))) << row[0] << " " << row[1] << " " << row[3];
    }
    EXPECT_GE(std::stod(row[9]), 0);
  }
}

TEST_F(QuickTable, HasEveryPartThatTheLibraryLists) {
  const auto fluxes = column(2);
  const auto limiters = column(3);
  const auto integrators = column(4);

  transport::for_each_entry(transport::FluxList{}, [&]<class Flux>() {
    EXPECT_TRUE(fluxes.contains(std::string{Flux::name})) << Flux::name;
  });
  transport::for_each_entry(transport::IntegratorList{}, [&]<class Integrator>() {
    EXPECT_TRUE(integrators.contains(std::string{Integrator::name})) << Integrator::name;
  });
  transport::for_each_entry(transport::LimiterList{}, [&]<class Limiter>() {
    const std::string name{Limiter::name};
    EXPECT_TRUE(limiters.contains(name) || limiters.contains(name + "(1)")) << name;
  });
}

// sin x at CFL 0.9 first order in space: each step keeps a known part of the wave, so its error is known too.
TEST_F(QuickTable, HasTheErrorOfUpwindOnASine) {
  constexpr double pi = 3.14159265358979323846;
  for (const auto& row : rows_) {
    if (row[0] != "advection" || row[1] != "piecewise_constant" || row[4] != "forward_euler") continue;
    const int n = std::stoi(row[5]);
    const int steps = std::stoi(row[7]);
    const double dx = 2 * pi / n;
    const double c = 2 * pi / steps / dx;
    // u^{m+1}_i = (1 - c) u_i + c u_{i-1}: factor 1 - c + c exp(-i dx) per step, exact exp(-i c dx)
    const double real = 1 - c + c * std::cos(dx);
    const double imaginary = -c * std::sin(dx);
    const double modulus = std::pow(std::hypot(real, imaginary), steps);
    const double lag = steps * (std::atan2(imaginary, real) + c * dx);
    const double amplitude = std::hypot(modulus * std::cos(lag) - 1, modulus * std::sin(lag));
    // Averages of the sine over cells are smaller by sin(dx/2)/(dx/2), and the mean of |sin| over n points is
    // 2/pi but for dx^2/12 or less either way.
    const double error = 2 * pi * (2 / pi) * amplitude * std::sin(dx / 2) / (dx / 2);
    EXPECT_NEAR(std::stod(row[10]), error, dx * dx / 12 * error);
  }
}

TEST(Charts, SayWhichFileTheyCannotWrite) {
  const Result run = scree_charts("--quick --problem advection -o /nowhere/table.csv");

  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.output, "scree_charts: cannot write /nowhere/table.csv\n");
}

}  // namespace
}  // namespace scree::charts
