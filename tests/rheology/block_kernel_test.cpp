// The kernel of every law for every instruction set that runs here, against the law point by point.

#include "law_in_blocks.hpp"

#include <scree/rheology/laws/kinetic_theory.hpp>
#include <scree/rheology/laws/newtonian.hpp>
#include <scree/update_block.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace scree::rheology {
namespace {

constexpr double time_step = 1e-3;  // [s]
constexpr std::size_t num_points = 16;
constexpr std::size_t many_points = 136;

class EveryLawInBlocks : public ::testing::TestWithParam<LawInBlocks> {
 protected:
  const LawInBlocks& law = GetParam();

  /// What rounding may do to each number in a step.
  ///
  /// An operation errs like a relative change of what it works on by `round_off`. So a number errs by the
  /// number of operations times `round_off` times what it changes by per relative change of each argument,
  /// and of itself: of the largest component, if it is one of a tensor, which is summed from parts as large.
  /// The longest way through a law is an eigen-system, fifteen rotations of some ten operations, and as many
  /// operations around it. An elementary function of a register counts as eight: its manual promises four
  /// units in the last place, each of two `round_off`.
  [[nodiscard]] Numbers rounding(const Numbers& before, bool is_plane) const {
    constexpr double num_operations = 300;
    constexpr double change = 1e-7;  // small against what any law bends over, large against rounding
    Numbers after = before;
    law.update_by_points(after, time_step, is_plane);
    Numbers error = sizes(after);
    for (std::size_t i = 0; i < law.num_arguments(); ++i) {
      Numbers less = before;
      Numbers more = before;
      for (double& number : less[i]) number *= 1 - change;
      for (double& number : more[i]) number *= 1 + change;
      law.update_by_points(less, time_step, is_plane);
      law.update_by_points(more, time_step, is_plane);
      for (std::size_t k = 0; k < error.size(); ++k) {
        for (std::size_t p = 0; p < num_points; ++p) {
          error[k][p] +=
              std::max(std::abs(less[k][p] - after[k][p]), std::abs(more[k][p] - after[k][p])) / change;
        }
      }
    }
    for (auto& column : error) {
      for (double& e : column) e *= num_operations * round_off;
    }
    return error;
  }

  static void expect_near(const Numbers& numbers, const Numbers& expected, const Numbers& error) {
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      for (std::size_t p = 0; p < num_points; ++p) {
        EXPECT_NEAR(numbers[k][p], expected[k][p], error[k][p]) << "column " << k << ", point " << p;
      }
    }
  }

 private:
  /// The magnitude of each number: of the largest component of the stress, and of the states of one unit.
  [[nodiscard]] Numbers sizes(const Numbers& numbers) const {
    Numbers result = numbers;
    const auto are_of_one_tensor = [&](std::size_t k, std::size_t other) {
      const std::size_t stress = law.num_arguments();
      if (k >= stress || other >= stress) return k >= stress && other >= stress;
      if (k < law.first_state() || other < law.first_state()) return k == other;
      return law.units_of_state[k - law.first_state()] == law.units_of_state[other - law.first_state()];
    };
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      for (std::size_t p = 0; p < num_points; ++p) {
        result[k][p] = 0;
        for (std::size_t other = 0; other < numbers.size(); ++other) {
          if (are_of_one_tensor(k, other)) result[k][p] = std::max(result[k][p], std::abs(numbers[other][p]));
        }
      }
    }
    return result;
  }
};
INSTANTIATE_TEST_SUITE_P(List, EveryLawInBlocks, ::testing::ValuesIn(laws_in_blocks()),
                         [](const auto& entry) { return entry.param.name; });

TEST_P(EveryLawInBlocks, HasAKernel) {
  for (const InstructionSet set : instruction_sets()) EXPECT_TRUE(law.has_kernel(set)) << name_of(set);
}

TEST_P(EveryLawInBlocks, IsUpdatedLikeItsPoints) {
  for (const bool is_plane : {false, true}) {
    const Numbers before = law.some_points(num_points, time_step, is_plane);
    const Numbers error = rounding(before, is_plane);
    Numbers expected = before;
    law.update_by_points(expected, time_step, is_plane);
    for (const InstructionSet set : instruction_sets()) {
      SCOPED_TRACE(std::string{name_of(set)} + (is_plane ? " in a plane" : ""));
      Numbers numbers = before;

      const BlockStiffness report = law.update(set, numbers, time_step, is_plane);

      EXPECT_EQ(report.unsolved, 0);
      EXPECT_EQ(report.unsolved_point, -1);
      expect_near(numbers, expected, error);
    }
  }
}

/// NaN where they have NaN, unsolved where they are: elementary functions of whole registers must answer what
/// is no number, or out of range, like those of one. The other points of the pack do not notice.
TEST_P(EveryLawInBlocks, AnswersUnsoundNumbersLikeItsPoints) {
  constexpr std::size_t spoilt = 5;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto kind_of = [](double x) { return std::isfinite(x) ? 0 : std::isnan(x) ? 1 : x > 0 ? 2 : 3; };
  for (const bool is_plane : {false, true}) {
    const Numbers sound = law.some_points(num_points, time_step, is_plane);
    for (std::size_t i = 0; i < law.num_arguments(); ++i) {
      // A strain with a zero in it is on the edge of what has a logarithm: rounding decides.
      const double nothing = i < law.first_state() ? 0 : -infinity;
      for (const double number : {std::nan(""), infinity, -infinity, nothing, -sound[i][spoilt]}) {
        Numbers before = sound;
        before[i][spoilt] = number;
        Numbers expected = before;
        const BlockStiffness expected_report = law.update_by_points(expected, time_step, is_plane);
        for (const InstructionSet set : instruction_sets()) {
          SCOPED_TRACE(std::string{name_of(set)} + ", " + std::to_string(number) + " in " +
                       std::to_string(i));
          Numbers numbers = before;
          Numbers undisturbed = sound;

          const BlockStiffness report = law.update(set, numbers, time_step, is_plane);

          law.update(set, undisturbed, time_step, is_plane);
          EXPECT_EQ(report.unsolved > 0, expected_report.unsolved > 0);
          for (std::size_t k = 0; k < numbers.size(); ++k) {
            EXPECT_EQ(kind_of(numbers[k][spoilt]), kind_of(expected[k][spoilt])) << "column " << k;
            if (k == i) continue;
            numbers[k][spoilt] = undisturbed[k][spoilt];
            EXPECT_EQ(numbers[k], undisturbed[k]) << "the other points, column " << k;
          }
        }
      }
    }
  }
}

[[nodiscard]] std::uint64_t bits_of(double number) {
  return std::bit_cast<std::uint64_t>(number);
}

/// A point is computed alike in each lane, and wherever in a block, of which a part goes through a predictor
/// before its corrector: it does not matter where it is sorted to.
TEST_P(EveryLawInBlocks, GivesAPointTheSameBitsInEachLane) {
  for (const bool is_plane : {false, true}) {
    for (const InstructionSet set : instruction_sets()) {
      SCOPED_TRACE(std::string{name_of(set)} + (is_plane ? " in a plane" : ""));
      Numbers numbers = law.some_points(many_points, time_step, is_plane);
      Numbers turned = numbers;
      const auto turn = [](std::vector<double>& column) { std::ranges::rotate(column, column.begin() + 5); };
      std::ranges::for_each(turned, turn);

      law.update(set, numbers, time_step, is_plane);
      law.update(set, turned, time_step, is_plane);

      std::ranges::for_each(numbers, turn);
      for (std::size_t k = 0; k < numbers.size(); ++k) {
        EXPECT_TRUE(std::ranges::equal(turned[k], numbers[k], {}, bits_of, bits_of)) << "column " << k;
      }
    }
  }
}

/// Against blocks that hold one of the points eight times, for which the largest is its own.
TEST_P(EveryLawInBlocks, ReportsTheLargestOfItsPoints) {
  for (const InstructionSet set : instruction_sets()) {
    SCOPED_TRACE(name_of(set));
    Numbers numbers = law.some_points(num_points, time_step);
    BlockStiffness largest;
    for (std::size_t p = 0; p < num_points; ++p) {
      Numbers alike;
      for (const auto& column : numbers) alike.emplace_back(static_cast<std::size_t>(pack_size), column[p]);
      largest.widen(law.update(set, alike, time_step, false));
    }

    const BlockStiffness report = law.update(set, numbers, time_step, false);

    EXPECT_EQ(report.wave_speed, largest.wave_speed);
    EXPECT_EQ(report.kinematic_viscosity, largest.kinematic_viscosity);
    EXPECT_EQ(report.relaxation_rate, largest.relaxation_rate);
    EXPECT_GT(report.wave_speed, 0);
  }
}

/// The components that a flow in a plane lacks are read as zeros, and not written: those of shear along z,
/// and in plane strain zz too.
TEST_P(EveryLawInBlocks, ReadsZerosWhereARunHasNoComponent) {
  constexpr std::array<std::size_t, 5> shear_and_zz{2, 5, 6, 7, 8};
  const auto stress_of = [&](Numbers& numbers, std::size_t i) -> std::vector<double>& {
    return numbers[law.num_arguments() + i];
  };
  for (const Places absent : {Places{out_of_plane}, Places{shear_and_zz}}) {
    Numbers zeros = law.some_points(num_points, time_step, true);
    for (const std::size_t i : absent) std::ranges::fill(zeros[i], 0);
    const Numbers error = rounding(zeros, false);
    for (const InstructionSet set : instruction_sets()) {
      SCOPED_TRACE(std::string{name_of(set)} + " without " + std::to_string(absent.size()));
      Numbers numbers = zeros;
      Numbers plane = zeros;
      for (const std::size_t i : absent) std::ranges::fill(plane[i], std::nan(""));

      law.update(set, numbers, time_step, false);
      law.update_without(set, plane, time_step, absent);

      for (const std::size_t i : absent) {
        plane[i] = zeros[i];
        EXPECT_EQ(stress_of(plane, i), stress_of(zeros, i)) << "stress " << i;
        stress_of(plane, i) = stress_of(numbers, i);
      }
      if (law.has_plane_form) {
        expect_near(plane, numbers, error);
      } else {
        EXPECT_EQ(plane, numbers);
      }
    }
  }
}

/// Beyond close packing the kinetic theory has no solution.
TEST(BlockKernel, NamesThePointThatItCouldNotSolve) {
  const KineticTheory typical_law = typical<KineticTheory>();
  const LawInBlocks law = law_in_blocks("kinetic_theory");
  const auto report_of = [&](InstructionSet set, auto fraction_at) {
    Numbers numbers(law.num_arguments() + 9, std::vector<double>(num_points, 1e-3));
    for (std::size_t p = 0; p < num_points; ++p) numbers[9][p] = fraction_at(p) * typical_law.grain_density;
    return law.update(set, numbers, time_step, false);
  };
  for (const InstructionSet set : instruction_sets()) {
    SCOPED_TRACE(name_of(set));
    for (std::size_t worst = 0; worst < num_points; ++worst) {
      const BlockStiffness report = report_of(set, [&](std::size_t p) {
        return p == worst ? 0.70 : p == (worst + 3) % num_points ? 0.65 : 0.4;
      });

      EXPECT_EQ(report.unsolved_point, static_cast<Index>(worst));
      EXPECT_NEAR(report.unsolved, 0.70 / typical_law.close_packing, 6 * round_off);  // five roundings
    }
    const BlockStiffness of_equals = report_of(set, [](std::size_t p) { return p % 5 == 4 ? 0.7 : 0.4; });
    EXPECT_EQ(of_equals.unsolved_point, 4);  // the first
  }
}

/// A law that is one of the list in all but its update.
struct Halved : Newtonian {
  template <class Real>
  [[nodiscard]] Response<Real, State<Real>> update(const Deformation<Real>& deformation,
                                                   const Input<Real>& input, const State<Real>& old,
                                                   Real dt) const noexcept {
    return {Real(0.5) * Newtonian::update(deformation, input, old, dt).stress, {}};
  }
};

TEST(BlockKernel, IsNotThatOfABase) {
  const Halved law{typical<Newtonian>()};

  EXPECT_EQ(block_kernel(law, InstructionSet::baseline), nullptr);
  EXPECT_EQ(kernel_of(law, InstructionSet::baseline), (&update_block<double, Halved>));
}

}  // namespace
}  // namespace scree::rheology
