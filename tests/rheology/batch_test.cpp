// Batches of any length against the kernels, which block_kernel_test.cpp has against the laws point by point.

#include "law_in_blocks.hpp"
#include "points.hpp"

#include <scree/rheology/batch.hpp>
#include <scree/rheology/laws/drucker_prager.hpp>
#include <scree/rheology/laws/kinetic_theory.hpp>
#include <scree/rheology/laws/mu_of_i.hpp>
#include <scree/rheology/laws/newtonian.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace scree::rheology {
namespace {

constexpr double time_step = 1e-3;  // [s]
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<std::size_t, 9> lengths{0, 1, 5, 7, 8, 9, 15, 16, 17};
constexpr std::size_t longest = 24;  // whole packs, and more than any of them

/// What a call says in its InputError, empty if it accepts.
template <class Call>
[[nodiscard]] std::string refusal(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

class EveryLawInBatches : public ::testing::TestWithParam<LawInBlocks> {
 protected:
  const LawInBlocks& law = GetParam();

  /// Columns of a batch that it writes: the states, and the stress above its diagonal.
  [[nodiscard]] bool is_written(std::size_t column, bool is_plane = false) const {
    if (column < law.num_arguments()) return column >= law.first_state();
    const std::size_t place = column - law.num_arguments();
    if (is_plane && is_out_of_plane(place)) return false;
    return std::ranges::count(detail::places_of_stress, place) == 1;
  }
};
INSTANTIATE_TEST_SUITE_P(List, EveryLawInBatches, ::testing::ValuesIn(laws_in_blocks()),
                         [](const auto& entry) { return entry.param.name; });

/// Each point has the bits that it has in a block, and nothing beyond the last is touched.
TEST_P(EveryLawInBatches, OfAnyLengthHaveTheBitsOfTheKernel) {
  for (const bool is_plane : {false, true}) {
    const Numbers before = law.some_points(longest, time_step, is_plane);
    for (const InstructionSet set : instruction_sets()) {
      Numbers by_kernel = before;
      law.update(set, by_kernel, time_step, is_plane);
      for (const std::size_t length : lengths) {
        SCOPED_TRACE(std::string{name_of(set)} + (is_plane ? " in a plane, " : ", ") +
                     std::to_string(length));
        Numbers numbers = before;

        law.update_batch(set, numbers, length, time_step, is_plane);

        for (std::size_t k = 0; k < numbers.size(); ++k) {
          const auto end = static_cast<Index>(is_written(k, is_plane) ? length : 0);
          EXPECT_TRUE(std::equal(numbers[k].begin(), numbers[k].begin() + end, by_kernel[k].begin())) << k;
          EXPECT_TRUE(std::equal(numbers[k].begin() + end, numbers[k].end(), before[k].begin() + end)) << k;
        }
      }
    }
  }
}

/// Against batches of one point each.
TEST_P(EveryLawInBatches, ReportTheLargestOfTheirPoints) {
  const Numbers before = law.some_points(longest, time_step);
  for (const std::size_t length : lengths) {
    BlockStiffness largest;
    for (std::size_t p = 0; p < length; ++p) {
      Numbers one;
      for (const auto& column : before) one.emplace_back(1, column[p]);
      largest.widen(law.update_batch(widest_instruction_set(), one, 1, time_step, false));
    }
    Numbers numbers = before;

    const BlockStiffness report =
        law.update_batch(widest_instruction_set(), numbers, length, time_step, false);

    EXPECT_EQ(report.wave_speed, largest.wave_speed) << length;
    EXPECT_EQ(report.kinematic_viscosity, largest.kinematic_viscosity);
    EXPECT_EQ(report.relaxation_rate, largest.relaxation_rate);
    EXPECT_EQ(report.unsolved, 0);
    EXPECT_EQ(report.unsolved_point, -1);
    EXPECT_EQ(report.wave_speed > 0, length > 0);
  }
}

/// A NaN in any column that is read, and nothing else, is refused.
TEST_P(EveryLawInBatches, AreRefusedForANanInAnyColumn) {
  const Numbers good = law.some_points(8, time_step);
  for (std::size_t k = 0; k < good.size(); ++k) {
    const bool is_read = k < law.num_arguments();
    Numbers numbers = good;
    numbers[k][5] = nan;

    const std::string message = refusal([&] { law.validate_columns(numbers); });

    EXPECT_EQ(message.find("of point 5: must ") != message.npos, is_read) << k << ' ' << message;
    EXPECT_EQ(message.empty(), !is_read);
  }
}

/// A column that is a number short is refused, whichever it is, and then nothing is written.
TEST_P(EveryLawInBatches, AreRefusedForAColumnThatIsTooShort) {
  const Numbers good = law.some_points(8, time_step);
  for (std::size_t k = 0; k < good.size(); ++k) {
    if (k >= law.num_arguments() && !is_written(k)) continue;
    Numbers numbers = good;
    numbers[k].pop_back();
    const Numbers before = numbers;

    const std::string message =
        refusal([&] { law.update_batch(InstructionSet::baseline, numbers, 8, time_step, false); });

    EXPECT_NE(message, "") << k;
    EXPECT_EQ(numbers, before);
  }
}

/// Thirteen points of a fluid of grains.
struct Beads {
  std::vector<double> zeros = std::vector<double>(13);
  std::vector<double> shear_rate = std::vector<double>(13, 4.0);
  std::vector<double> density = std::vector<double>(13, 1501.0);
  std::vector<double> size = std::vector<double>(13, 1e-3);
  std::array<std::vector<double>, 6> stress{};

  [[nodiscard]] LawColumns<MuOfI> columns() {
    LawColumns<MuOfI> result;
    result.velocity_gradient.fill(zeros);
    result.velocity_gradient[1] = shear_rate;
    result.density = density;
    result.inputs = {size};
    for (std::size_t i = 0; i < 6; ++i) {
      stress[i].resize(13);
      result.stress[i] = stress[i];
    }
    return result;
  }
};

TEST(UpdateBatch, LetsColumnsOfZerosBeShared) {
  Beads beads;
  const MuOfI law = typical<MuOfI>();

  update_batch(law, beads.columns(), time_step, InstructionSet::baseline);

  const Tensor<double> expected = stress(law, simple_shear(4), 1501.0, 1e-3);
  for (std::size_t p = 0; p < 13; ++p) {
    // Some twenty operations, contracted or not; the pressure is a difference of numbers near K.
    EXPECT_NEAR(beads.stress[1][p], expected(1, 1), 20 * round_off * law.bulk_modulus);
    EXPECT_NEAR(beads.stress[3][p], expected(0, 1), 20 * round_off * law.bulk_modulus);
  }
}

TEST(UpdateBatch, NamesTheColumnThatIsNotAsLongAsTheOthers) {
  Beads beads;
  const MuOfI law = typical<MuOfI>();
  const auto refused = [&](auto change) {
    LawColumns<MuOfI> columns = beads.columns();
    change(columns);
    return refusal([&] { update_batch(law, columns, time_step); });
  };

  EXPECT_EQ(refused([&](auto& c) { c.stress[5] = c.stress[5].first(12); }),
            "the law 'mu_of_i' is given 12 numbers as stress_yz: must be 13, as many as of density");
  EXPECT_EQ(
      refused([&](auto& c) { c.velocity_gradient[3] = {}; }),
      "the law 'mu_of_i' is given 0 numbers as velocity_gradient_yx: must be 13, as many as of density");
  const auto leave_the_plane_out = [&](auto& c) {
    for (const std::size_t i : out_of_plane) c.velocity_gradient[i] = {};
    c.stress[3] = {};
  };
  EXPECT_EQ(refused(leave_the_plane_out),
            "the law 'mu_of_i' is given 0 numbers as stress_xy: must be 13, as many as of density");
  EXPECT_EQ(refused([&](auto& c) { c.stress[4] = {}; }),
            "the law 'mu_of_i' is given 0 numbers as stress_xz: must be 13, as many as of density");
  EXPECT_EQ(refused([&](auto& c) { c.inputs[0] = c.inputs[0].first(1); }),
            "the law 'mu_of_i' is given 1 numbers as grain_size: must be 13, as many as of density");
  EXPECT_EQ(
      refused([&](auto& c) { c.density = c.density.first(8); }),
      "the law 'mu_of_i' is given 13 numbers as velocity_gradient_xx: must be 8, as many as of density");
}

TEST(UpdateBatch, NamesAStepThatIsNone) {
  Beads beads;
  const auto refused = [&](double dt) {
    return refusal([&] { update_batch(typical<MuOfI>(), beads.columns(), dt); });
  };

  EXPECT_EQ(refused(0), "the law 'mu_of_i' is given a step of 0 s: must be finite and above 0");
  EXPECT_EQ(refused(-1), "the law 'mu_of_i' is given a step of -1 s: must be finite and above 0");
  EXPECT_EQ(refused(nan), "the law 'mu_of_i' is given a step of nan s: must be finite and above 0");
}

TEST(ValidateColumns, NamesColumnValuePointAndRange) {
  Beads beads;
  const auto refused = [&](auto& column, std::size_t p, double value) {
    const double good = column[p];
    column[p] = value;
    std::string message = refusal([&] { validate_columns(beads.columns()); });
    column[p] = good;
    return message;
  };

  EXPECT_EQ(refusal([&] { validate_columns(beads.columns()); }), "");
  EXPECT_EQ(refused(beads.size, 12, 0.0),
            "the law 'mu_of_i' reads grain_size = 0 m of point 12: must be finite and above 0");
  EXPECT_EQ(refused(beads.density, 3, -1.0),
            "the law 'mu_of_i' reads density = -1 kg/m^3 of point 3: must be finite and above 0");
  EXPECT_EQ(refused(beads.shear_rate, 0, -std::numeric_limits<double>::infinity()),
            "the law 'mu_of_i' reads velocity_gradient_xy = -inf 1/s of point 0: must be finite");
  beads.size.pop_back();
  EXPECT_EQ(refusal([&] { validate_columns(beads.columns()); }),
            "the law 'mu_of_i' is given 12 numbers as grain_size: must be 13, as many as of density");
}

/// Which the form of a law for a plane does not read.
TEST(ValidateColumns, RefusesMemoryThatAPlaneLacks) {
  const std::vector<double> numbers(8, 0.01);
  std::vector<double> memory(8, 0.01);
  LawColumns<DruckerPrager> columns;
  for (const std::size_t i : {0U, 1U, 3U, 4U, 8U}) columns.velocity_gradient[i] = numbers;
  columns.density = numbers;
  columns.states.fill(memory);
  std::vector<double> balance(8, -0.02);  // of the trace
  columns.states[2] = balance;
  columns.stress.fill(memory);
  const auto refused = [&] { return refusal([&] { validate_columns(columns); }); };

  EXPECT_EQ(refused(), "the law 'drucker_prager' reads elastic_strain_xz = 0.01 of point 0: must be 0");
  std::vector<double> none(8);
  columns.states[4] = columns.states[5] = none;
  EXPECT_EQ(refused(), "");
}

/// Which one form of a law would take for pressure and another drop. In single precision it is of trace 0.
TEST(ValidateColumns, RefusesATraceOfADeviator) {
  const std::vector<double> numbers(8, 1.0);
  std::array<std::vector<double>, 6> memory;
  const std::array<double, 6> strain{0.1, 0.2, -0.3, 3.0, 0, 0};
  LawColumns<DruckerPrager> columns;
  columns.velocity_gradient.fill(numbers);
  columns.density = numbers;
  std::vector<double> stress(8);
  columns.stress.fill(stress);
  for (std::size_t i = 0; i < 6; ++i) {
    memory[i].assign(8, static_cast<double>(static_cast<float>(strain[i])));
    columns.states[i] = memory[i];
  }
  const auto refused = [&] { return refusal([&] { validate_columns(columns); }); };

  EXPECT_EQ(refused(), "");
  memory[1][6] = 0.2 + 0.9e-6 * 3.0;
  EXPECT_EQ(refused(), "");
  memory[1][6] = 0.2 - 0.1;
  EXPECT_EQ(
      refused(),
      "the law 'drucker_prager' reads elastic_strain_xx + elastic_strain_yy + elastic_strain_zz = -0.1 of "
      "point 6: must be 0");
  memory[1][6] = 0.2 + 1.1e-6 * 3.0;
  EXPECT_NE(refused(), "");
}

/// What is not checked in each call, and the remedy: a NaN reaches the stress of its own point, and of no
/// other.
TEST(UpdateBatch, LeavesANanToThoseWhoValidate) {
  Beads beads;
  beads.size[10] = nan;

  update_batch(typical<MuOfI>(), beads.columns(), time_step);

  for (std::size_t p = 0; p < 13; ++p) EXPECT_EQ(std::isnan(beads.stress[3][p]), p == 10) << p;
  EXPECT_EQ(refusal([&] { validate_columns(beads.columns()); }),
            "the law 'mu_of_i' reads grain_size = nan m of point 10: must be finite and above 0");
}

/// Beyond close packing the kinetic theory has no solution. The worst is named, the first of those as bad,
/// in whole packs and after them.
TEST(UpdateBatch, NamesThePointThatItCouldNotSolve) {
  const KineticTheory gas = typical<KineticTheory>();
  const LawInBlocks law = law_in_blocks("kinetic_theory");
  const auto unsolved_point = [&](auto fraction_at) {
    Numbers numbers(law.num_arguments() + 9, std::vector<double>(11, 1e-3));
    for (std::size_t p = 0; p < 11; ++p) numbers[9][p] = fraction_at(p) * gas.grain_density;
    return law.update_batch(widest_instruction_set(), numbers, 11, time_step, false).unsolved_point;
  };

  for (std::size_t worst = 0; worst < 11; ++worst) {
    EXPECT_EQ(unsolved_point([&](std::size_t p) {
                return p == worst ? 0.7 : p == (worst + 5) % 11 ? 0.65 : 0.4;
              }),
              static_cast<Index>(worst));
  }
  EXPECT_EQ(unsolved_point([](std::size_t p) { return p == 6 || p == 9 ? 0.7 : 0.4; }), 6);
  EXPECT_EQ(unsolved_point([](std::size_t p) { return p >= 9 ? 0.7 : 0.4; }), 9);
}

/// A law of a user's own, with no kernel: it runs point by point.
struct Halved : Newtonian {
  template <class Real>
  [[nodiscard]] Response<Real, State<Real>> update(const Deformation<Real>& deformation,
                                                   const Input<Real>& input, const State<Real>& old,
                                                   Real dt) const noexcept {
    return {Real(0.5) * Newtonian::update(deformation, input, old, dt).stress, {}};
  }
};

TEST(UpdateBatch, TakesAnyLaw) {
  const Halved law{typical<Newtonian>()};
  const std::vector<double> zeros(9);
  const std::vector<double> shear(9, 4.0);
  const std::vector<double> density(9, law.density);
  std::array<std::vector<double>, 6> stress;
  LawColumns<Halved> columns;
  columns.velocity_gradient.fill(zeros);
  columns.velocity_gradient[1] = shear;
  columns.density = density;
  for (std::size_t i = 0; i < 6; ++i) {
    stress[i].resize(9);
    columns.stress[i] = stress[i];
  }

  update_batch(law, columns, time_step);

  for (const double shear_stress : stress[3]) EXPECT_EQ(shear_stress, 2 * law.viscosity);
}

}  // namespace
}  // namespace scree::rheology
