#include "shear_problem.hpp"

#include <gtest/gtest.h>

namespace scree::rheology {
namespace {

TEST(Multigrid, TakesAsManyIterationsOnAnyMesh) {  // from 32^2 to 128^2; 256^2 is in multigrid_verify.cpp
  const long coarse = test::shear_iterations<2>(32, ViscousPreconditioner::multigrid);
  const long fine = test::shear_iterations<2>(128, ViscousPreconditioner::multigrid);
  EXPECT_LE(static_cast<double>(fine), 1.5 * static_cast<double>(coarse));
}

TEST(Multigrid, CoversOddAndPeriodicMeshes) {
  const long even = test::shear_iterations<2>(32, ViscousPreconditioner::multigrid);
  const long odd = test::shear_iterations<2>(33, ViscousPreconditioner::multigrid);
  const long periodic = test::shear_iterations<2>(32, ViscousPreconditioner::multigrid, true);
  EXPECT_LE(static_cast<double>(odd), 1.5 * static_cast<double>(even));
  EXPECT_LE(static_cast<double>(periodic), 1.5 * static_cast<double>(even));
}

TEST(Multigrid, WorksInThreeDimensions) {
  const long coarse = test::shear_iterations<3>(6, ViscousPreconditioner::multigrid);
  const long fine = test::shear_iterations<3>(12, ViscousPreconditioner::multigrid);
  EXPECT_LE(static_cast<double>(fine), 1.5 * static_cast<double>(coarse));
}

TEST(Jacobi, TakesTwiceTheIterationsOnAMeshTwiceAsFine) {  // where it fails: its condition grows as 1/dx^2
  const long coarse = test::shear_iterations<2>(16, ViscousPreconditioner::jacobi);
  const long fine = test::shear_iterations<2>(32, ViscousPreconditioner::jacobi);
  EXPECT_NEAR(static_cast<double>(fine) / static_cast<double>(coarse), 2, 0.3);
}

TEST(Line, IsExactInOneDimension) {
  EXPECT_LE(test::shear_iterations<1>(64, ViscousPreconditioner::line), 2);
}

}  // namespace
}  // namespace scree::rheology
