// The program behind the charts of material points: its small table has the errors that the schemes are known
// for.

#include "run_program.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace scree::charts {
namespace {

/// Errors by "transfer,order" of the quick table of a problem, all of quadratic splines with 2 x 2 points, on
/// its coarsest mesh.
struct QuickTable {
  std::string header{};
  std::map<std::string, double> errors{};
  int status = 0;
};

[[nodiscard]] QuickTable quick_table(const std::string& problem, const std::string& cells_along) {
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
    EXPECT_EQ(cells[0] + cells[1] + cells[4] + cells[5], problem + "quadratic2" + cells_along);
    table.errors[cells[2] + "," + cells[3]] = std::stod(cells[7]);
  }
  std::remove(file.c_str());
  return table;
}

TEST(MpmCharts, QuickTableHasEveryTransferAndOrder) {
  const QuickTable table = quick_table("swing", "8");

  EXPECT_EQ(table.status, 0);
  EXPECT_EQ(table.header, "problem,shape,transfer,order,points_per_axis,cells,cpu_seconds,error");
  for (const std::string transfer : {"aflip", "apic", "flip", "pic", "tpic", "xpic_2"}) {
    std::set<double> errors;  // which order the steps were of shows
    for (const char* order : {",usl", ",musl", ",usf"}) errors.insert(table.errors.at(transfer + order));
    EXPECT_EQ(errors.size(), 3U) << transfer;
  }
  // PIC damps the swing away: its points lag by about as much as they should move.
  EXPECT_LT(table.errors.at("apic,usl"), 0.5 * table.errors.at("pic,usl"));
  EXPECT_LT(table.errors.at("flip,usl"), table.errors.at("pic,usl"));
}

/// Which order the steps were of shows in where the mass has come to lie too; but that is told in shares of
/// few points, which may by chance be alike for one transfer.
TEST(MpmCharts, ColumnCollapsesInEveryOrder) {
  const QuickTable table = quick_table("collapse", "6");

  EXPECT_EQ(table.status, 0);
  int num_changed = 0;
  for (const std::string transfer : {"aflip", "apic", "flip", "tpic", "xpic_2"}) {
    if (table.errors.at(transfer + ",usl") != table.errors.at(transfer + ",musl")) ++num_changed;
    EXPECT_EQ(table.errors.count(transfer + ",usf"), 1U) << transfer;
  }
  EXPECT_GE(num_changed, 4);
  EXPECT_LT(table.errors.at("apic,usl"), 0.5 * table.errors.at("pic,usl"));
}

TEST(MpmCharts, SaysThatItCannotWrite) {
  const auto run = testing::run_program(SCREE_MPM_CHARTS, "--quick --problem swing -o /nowhere/table.csv");

  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.output, "scree_mpm_charts: cannot write /nowhere/table.csv\n");
}

}  // namespace
}  // namespace scree::charts
