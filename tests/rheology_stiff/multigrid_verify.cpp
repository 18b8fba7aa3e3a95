#include "shear_problem.hpp"

#include <gtest/gtest.h>

#include <cstdio>

namespace scree::rheology {
namespace {

TEST(Multigrid, TakesAsManyIterationsFrom64To256CellsAlongAnAxis) {
  const long coarse = test::shear_iterations<2>(64, ViscousPreconditioner::multigrid);
  const long fine = test::shear_iterations<2>(256, ViscousPreconditioner::multigrid);
  std::printf("iterations per step: %ld at 64^2, %ld at 256^2\n", coarse, fine);
  EXPECT_LE(static_cast<double>(fine), 1.5 * static_cast<double>(coarse));
}

}  // namespace
}  // namespace scree::rheology
