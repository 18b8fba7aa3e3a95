// The program behind the charts of material points: its small table has the errors that the schemes are known
// for.

#include "run_program.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace scree::charts {
namespace {

/// Errors by "transfer,order" of the quick table of a problem, all of quadratic splines with 2 x 2 points.
struct QuickTable {
  std::string header{};
  std::map<std::string, double> errors{};
  int status = 0;
};

[[nodiscard]] QuickTable quick_table(const std::string& problem) {
  const std::string file = ::testing::TempDir() + "scree_mpm_charts_" + std::to_string(getpid()) + ".csv";
  QuickTable table;
  table.status =
      testing::run_program(SCREE_MPM_CHARTS, "--quick -o " + file + " --problem " + problem).exit_code;
  std::ifstream text{file};
  std::getline(text, table.header);
  for (std::string line; std::getline(text, line);) {
    std::vector<std::string> cells;
    std::istringstream row{line};
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    EXPECT_EQ(cells.size(), 8U) << line;
    EXPECT_EQ(cells[0] + cells[1] + cells[4] + cells[5], problem + "quadratic28");
    table.errors[cells[2] + "," + cells[3]] = std::stod(cells[7]);
  }
  std::remove(file.c_str());
  return table;
}

TEST(MpmCharts, QuickTableHasEveryTransferAndOrder) {
  const QuickTable table = quick_table("swing");

  EXPECT_EQ(table.status, 0);
  EXPECT_EQ(table.header, "problem,shape,transfer,order,points_per_axis,cells,cpu_seconds,error");
  for (const char* scheme : {"aflip,usl", "apic,usl", "apic,musl", "apic,usf", "flip,usl", "flip,musl",
                             "flip,usf", "pic,usl", "tpic,usl", "xpic_2,usl"}) {
    EXPECT_EQ(table.errors.count(scheme), 1U) << scheme;
  }
  // PIC damps the swing away: its points lag by about as much as they should move.
  EXPECT_LT(table.errors.at("apic,usl"), 0.5 * table.errors.at("pic,usl"));
  EXPECT_LT(table.errors.at("flip,usl"), table.errors.at("pic,usl"));
}

TEST(MpmCharts, SaysThatItCannotWrite) {
  const auto run = testing::run_program(SCREE_MPM_CHARTS, "--quick --problem swing -o /nowhere/table.csv");

  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.output, "scree_mpm_charts: cannot write /nowhere/table.csv\n");
}

}  // namespace
}  // namespace scree::charts
