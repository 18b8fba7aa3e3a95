// The program behind the charts of stiff rheology: its small table has the orders and counts of its methods.

#include "run_program.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace scree::charts {
namespace {

using Result = testing::ProgramResult;

Result rheology_charts(const std::string& arguments) {
  return testing::run_program(SCREE_RHEOLOGY_CHARTS, arguments);
}

struct Row {
  std::string problem, parameter, method{};
  double steps = 0, ratio = 0, applications = 0, cpu_seconds = 0, error = 0;
};

Row row_of(const std::string& line) {
  std::istringstream text{line};
  const auto cell = [&] {
    std::string result;
    std::getline(text, result, ',');
    return result;
  };
  Row row;
  for (std::string* name : {&row.problem, &row.parameter, &row.method}) *name = cell();
  for (double* number : {&row.steps, &row.ratio, &row.applications, &row.cpu_seconds, &row.error}) {
    *number = std::stod(cell());
  }
  return row;
}

struct Table {
  Result run;
  std::string header;
  std::vector<Row> rows;
};

Table quick_table(const std::vector<std::string>& problems) {
  // Each test may run in a process of its own, side by side with the others.
  const std::string file =
      ::testing::TempDir() + "scree_rheology_charts_" + std::to_string(getpid()) + ".csv";
  std::string arguments = "--quick -o " + file;
  for (const std::string& problem : problems) arguments += " --problem " + problem;
  Table table{rheology_charts(arguments), {}, {}};
  std::ifstream text{file};
  std::getline(text, table.header);
  for (std::string line; std::getline(text, line);) table.rows.push_back(row_of(line));
  std::remove(file.c_str());
  return table;
}

std::vector<Row> rows_of(const Table& table, const std::string& problem, const std::string& method) {
  std::vector<Row> rows;
  for (const Row& row : table.rows) {
    if (row.problem == problem && row.method == method) rows.push_back(row);
  }
  return rows;
}

/// From the last two runs of a method.
double order_of(const std::vector<Row>& rows) {
  const Row& coarse = rows.at(rows.size() - 2);
  const Row& fine = rows.back();
  return std::log(coarse.error / fine.error) / std::log(fine.steps / coarse.steps);
}

/// A motion that decays at a rate r is off by z r T/2 or less after steps of z/r, and beyond that by the same
/// squared, over 2. What lasts to the end has r T of 4 at most (exp(-4) is 2 %); of 64 and 128 steps the next
/// order is then 0.06 and 0.03 of the first, the measured order within 0.1 of its own.
TEST(RheologyCharts, HaveTheOrderOfEachMethodOnALayer) {  // Eqs. (R133), (R141), (R146)
  const Table table = quick_table({"newtonian_layer", "bingham_layer"});
  ASSERT_EQ(table.run.exit_code, 0) << table.run.output;

  for (const char* problem : {"newtonian_layer", "bingham_layer"}) {
    EXPECT_NEAR(order_of(rows_of(table, problem, "explicit")), 1, 0.1) << problem;
    EXPECT_NEAR(order_of(rows_of(table, problem, "implicit")), 1, 0.1) << problem;
    EXPECT_NEAR(order_of(rows_of(table, problem, "two_solves")), 2, 0.1) << problem;
    EXPECT_NEAR(order_of(rows_of(table, problem, "rkl2")), 2, 0.1) << problem;
  }
}

/// Stress relaxes to flow in 3e-6 s (grains) and 7e-6 s, 1/(G d gdot_p/d tau): 15 of the longer steps or
/// more, so that the next order is a 15th and a 30th of the first, and the measured one within their
/// difference over ln 2.
TEST(RheologyCharts, HaveFirstOrderOfClosedReturns) {  // Eqs. (R20), (R71), (R145)
  const double tolerance = (1.0 / 15 - 1.0 / 30) / std::log(2);
  const Table table = quick_table({"granular_point", "yield_stress_point"});

  EXPECT_NEAR(order_of(rows_of(table, "granular_point", "closed_return")), 1, tolerance);
  EXPECT_NEAR(order_of(rows_of(table, "yield_stress_point", "closed_return")), 1, tolerance);
}

TEST(RheologyCharts, CountEveryApplication) {
  const Table table = quick_table({"newtonian_layer", "granular_point"});
  ASSERT_FALSE(table.rows.empty());

  for (const Row& row : table.rows) {
    if (row.method == "explicit" || row.method == "closed_return") {
      EXPECT_EQ(row.applications, row.steps);
    }
    if (row.method == "rkl2") {  // the least odd number of stages, Eq. (R142)
      const double stages = row.applications / row.steps;
      EXPECT_EQ(std::fmod(stages, 2), 1);
      EXPECT_GE((stages * stages + stages - 2) / 4, row.ratio);
      const double fewer = stages - 2;
      if (fewer >= 3) {
        EXPECT_LT((fewer * fewer + fewer - 2) / 4, row.ratio);
      }
    }
  }
}

TEST(RheologyCharts, RepeatButForTheTime) {
  const Table first = quick_table({"newtonian_layer", "granular_point"});
  const Table second = quick_table({"newtonian_layer", "granular_point"});

  EXPECT_EQ(first.header, "problem,parameter,method,steps,ratio,applications,cpu_seconds,error");
  ASSERT_EQ(first.rows.size(), second.rows.size());
  ASSERT_FALSE(first.rows.empty());
  for (std::size_t i = 0; i < first.rows.size(); ++i) {
    EXPECT_EQ(first.rows[i].method, second.rows[i].method);
    EXPECT_EQ(first.rows[i].steps, second.rows[i].steps);
    EXPECT_EQ(first.rows[i].applications, second.rows[i].applications);
    EXPECT_EQ(first.rows[i].error, second.rows[i].error);
  }
}

TEST(RheologyCharts, SayWhichFileTheyCannotWrite) {
  const Result run = rheology_charts("--quick --problem granular_point -o /nowhere/table.csv");

  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.output, "scree_rheology_charts: cannot write /nowhere/table.csv\n");
}

}  // namespace
}  // namespace scree::charts
