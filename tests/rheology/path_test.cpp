// The driver itself: what it is asked for is what happens, and what cannot be is said.

#include "path_points.hpp"
#include "points.hpp"

#include <scree/error.hpp>
#include <scree/rheology/laws/drucker_prager.hpp>
#include <scree/rheology/laws/granular_elastoviscoplastic.hpp>
#include <scree/rheology/laws/kinetic_theory.hpp>
#include <scree/rheology/laws/mixture_mu_of_i.hpp>
#include <scree/rheology/laws/mu_of_i.hpp>
#include <scree/rheology/laws/newtonian.hpp>
#include <scree/rheology/laws/suspension.hpp>

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace scree::rheology {
namespace {

constexpr DruckerPrager sand = typical<DruckerPrager>();
constexpr Newtonian fluid = typical<Newtonian>();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Sand under 1 kPa.
[[nodiscard]] PathPointOf<DruckerPrager> pressed_sand() {
  PathPointOf<DruckerPrager> point{sand, sand.density};
  return {sand, density_at_pressure(point, 1e3)};
}

/// Each component by stress.
[[nodiscard]] Controls by_stress(const std::array<double, 6>& rates) {
  Controls controls;
  for (std::size_t k = 0; k < rates.size(); ++k) controls.on[k] = stress_rate(rates[k]);
  return controls;
}

TEST(Path, BeginsAtThePressureItIsGiven) {
  const auto point = pressed_sand();

  EXPECT_NEAR(mean_pressure(point.now.stress), 1e3, 8 * round_off * sand.bulk_modulus);
}

TEST(Path, DensityIsThatOfAMaterialPoint) {  // Eq. (R27)
  PathPointOf<Newtonian> point{fluid, fluid.density};

  const auto records = drive(point, oedometric(0.1), 1, 4);

  double density = fluid.density;
  for (int n = 0; n < 4; ++n) density /= 1 - 0.1 * 0.25;
  EXPECT_NEAR(point.now.density, density, 8 * round_off * density);  // a division and a sum a step
  EXPECT_DOUBLE_EQ(records.back().volumetric_strain, std::log(fluid.density / density));
  EXPECT_NEAR(point.now.strain(1, 1), -0.1, 4 * round_off);
}

/// All six stresses change as they are told to, at rates that are neither alike nor small.
TEST(Path, MeetsEveryStressItIsAskedFor) {  // Eq. (R28)
  const std::array<double, 6> rates{-300, -500, -400, 100, -50, 80};
  PathPointOf<DruckerPrager> point = pressed_sand();
  const Tensor<double> start = point.now.stress;

  const auto records = drive(point, by_stress(rates), 2, 20);

  for (const PathRecord& record : records) {
    for (std::size_t k = 0; k < rates.size(); ++k) {
      const auto [name, i, j] = symmetric_components[k];
      EXPECT_NEAR(record.at.stress(i, j), start(i, j) + rates[k] * record.at.time,
                  tolerance_of_stress(point, 2e3))
          << name << " at " << record.at.time;
    }
  }
}

TEST(Path, FluidUnderShearStressFlowsAtStressOverViscosity) {  // Eq. (R3)
  PathPointOf<Newtonian> point{fluid, 1.001 * fluid.density};
  Controls controls = simple_shear_at_constant_pressure(0);
  controls.on[first_shear] = stress_rate(150);

  const auto records = drive(point, controls, 1, 10);

  for (const PathRecord& record : records) {
    const double tolerance = tolerance_of_stress(point, largest(record.at.stress)) / fluid.viscosity;
    EXPECT_NEAR(record.velocity_gradient(0, 1), 150 * record.at.time / fluid.viscosity, 2 * tolerance);
    EXPECT_EQ(record.velocity_gradient(1, 0), 0);  // planes normal to y stay
  }
}

/// The motion that was found under mixed control, imposed step by step, gives the same stresses.
TEST(Path, IsTheSameAsItsMotionImposed) {
  PathPointOf<DruckerPrager> mixed = pressed_sand();
  PathPointOf<DruckerPrager> replayed = mixed;
  const auto records = drive(mixed, simple_shear_at_constant_pressure(0.1), 1, 50);

  for (std::size_t n = 1; n < records.size(); ++n) {
    drive(replayed, by_strain(records[n].velocity_gradient), 1.0 / 50, 1);

    // L is taken apart and put together again: a rounding of D and W, met by 2 G dt, each step.
    const double tolerance = static_cast<double>(n) * rounding_of_strain(sand);
    EXPECT_LE(largest(replayed.now.stress - records[n].at.stress), tolerance);
  }
}

/// The pressure of a fluid that is compressed along y while sigma_xx is held follows the stress by mu/K: in
/// steps that resolve this time, halving them halves the error. In longer ones it is there at once.
TEST(Path, IsOfFirstOrderInStepsThatResolveTheFluid) {
  const double relaxation = fluid.viscosity / fluid.bulk_modulus;  // [s]
  std::array<double, 3> pressure{};
  for (std::size_t level = 0; level < pressure.size(); ++level) {
    PathPointOf<Newtonian> point{fluid, 1.001 * fluid.density};
    drive(point, triaxial_drained(0.1), 2 * relaxation, 160 << level);
    pressure[level] = mean_pressure(point.now.stress);
  }

  const double order = std::log2((pressure[0] - pressure[1]) / (pressure[1] - pressure[2]));
  EXPECT_GE(order, 0.9);
  EXPECT_LE(order, 1.1);
}

TEST(Path, GoesOnFromAStoredRecord) {
  using Law = GranularElastoviscoplastic;
  constexpr Law law = typical<Law>();
  const std::array stages{Stage{"compressed", 1, 10, triaxial_drained(0.1)},
                          Stage{"sheared", 1, 10, simple_shear_at_constant_pressure(0.2)}};
  PathPointOf<Law> straight{law, 1.001 * law.density, {1e-3}};
  drive(straight, stages);

  PathPointOf<Law> stopped{law, 1.001 * law.density, {1e-3}};
  const PathRecord stored = drive(stopped, std::span{stages}.first(1)).back();
  std::array<double, Law::states.size()> memory{};
  std::ranges::copy(stored.state, memory.begin());
  PathPointOf<Law> reloaded{law, stored.at.density, {1e-3}, std::bit_cast<Law::State<double>>(memory)};
  reloaded.now = stored.at;
  drive(reloaded, std::span{stages}.last(1));

  EXPECT_EQ(reloaded.now.stress.components, straight.now.stress.components);
  EXPECT_EQ(reloaded.state(), straight.state());
  EXPECT_EQ(reloaded.now.time, straight.now.time);
}

TEST(Path, SaysWhichStressHasNoAnswer) {
  Newtonian inviscid = fluid;
  inviscid.viscosity = 0;
  PathPointOf<Newtonian> point{inviscid, 1.001 * fluid.density};
  const Stage held{"held", 1, 10, isotropic_compression(0)};
  Stage sheared{"sheared", 1, 10, {}};
  sheared.controls.on[first_shear] = stress_rate(100);

  EXPECT_EQ(message_of<RunError>([&] {
              drive(point, std::array{held, sheared});
            }),
            "the law 'newtonian' has no answer in stage 2 'sheared' at 1.1 s: stress xy is 0 Pa where 10 Pa "
            "is wanted, after 0 iterations");
}

/// Sand bears no more shear stress than friction times pressure: the path ends with the step before.
TEST(Path, EndsWhereSandYields) {  // Eq. (R24)
  PathPointOf<DruckerPrager> point = pressed_sand();
  Controls controls = simple_shear_at_constant_pressure(0);
  controls.on[first_shear] = stress_rate(100);

  const std::string message = message_of<RunError>([&] { drive(point, controls, 10, 1000); });

  // The pressure differs from that at the start by less than the square of the shear strain tau/G, on K.
  const double strength = sand.friction * 1e3;  // [Pa]
  const double strain = strength / sand.shear_modulus;
  const double step = 1;  // [Pa]
  EXPECT_NEAR(point.now.stress(0, 1), strength, step + sand.friction * strain * strain * sand.bulk_modulus);
  EXPECT_NE(message.find("the law 'drucker_prager' has no answer in stage 1 'the test' at "), message.npos);
  EXPECT_NE(message.find(": stress xy is "), message.npos) << message;
}

TEST(Path, LeavesThePointAsItWasBeforeAStepWithoutAnswer) {
  PathPointOf<DruckerPrager> point = pressed_sand();
  drive(point, triaxial_drained(0.1), 1, 10);
  const PathState before = point.now;
  const std::vector<double> memory = point.state();

  EXPECT_THROW(drive(point, by_stress({0, 0, 0, 1e6, 0, 0}), 1, 1), RunError);

  EXPECT_EQ(point.state(), memory);
  EXPECT_EQ(point.now.density, before.density);
  EXPECT_EQ(point.now.time, before.time);
  EXPECT_EQ(point.now.stress.components, before.stress.components);
}

TEST(Path, NamesAVolumeThatVanishes) {
  PathPointOf<Newtonian> point{fluid, fluid.density};

  EXPECT_EQ(message_of<RunError>([&] { drive(point, oedometric(2), 1, 1); }),
            "the law 'newtonian' has no answer in stage 1 'the test' at 1 s: density becomes -1000 kg/m^3");
}

TEST(Path, NamesAStressThatIsNotFinite) {
  PathPointOf<Newtonian> point{fluid, fluid.density};

  EXPECT_EQ(message_of<RunError>([&] { drive(point, simple_shear_at_constant_volume(1e308), 1, 1); }),
            "the law 'newtonian' has no answer in stage 1 'the test' at 1 s: its stress is not finite");
}

/// A gas of grains that is pressed beyond close packing: phi/phi_c is what its law says it could not solve.
TEST(Path, NamesWhatTheLawCouldNotSolve) {
  constexpr KineticTheory gas = typical<KineticTheory>();
  PathPointOf<KineticTheory> point{gas, 0.63 * gas.grain_density, {1e-3}};

  EXPECT_EQ(
      message_of<RunError>([&] { drive(point, oedometric(0.1), 1, 1); }),
      "the law 'kinetic_theory' has no answer in stage 1 'the test' at 1 s: its equations are left with "
      "a relative error of 1.09375");  // 0.63/0.9/0.64
}

TEST(BadPath, IsRefusedWithItsNumber) {
  const auto refused = [](const Stage& stage) { return message_of<InputError>([&] { validate(stage); }); };
  const Stage good{"load", 1, 10, oedometric(0.1)};
  EXPECT_EQ(refused(good), "no error");

  Stage bad = good;
  bad.duration = nan;
  EXPECT_EQ(refused(bad), "stage 'load': duration = nan: must be finite and above 0 s");
  bad = good;
  bad.num_steps = 0;
  EXPECT_EQ(refused(bad), "stage 'load': num_steps = 0: must be at least 1");
  bad = good;
  bad.controls.on[1] = strain_rate(nan);
  EXPECT_EQ(refused(bad), "stage 'load': strain rate yy = nan: must be finite");
  bad.controls.on[1] = stress_rate(nan);
  EXPECT_EQ(refused(bad), "stage 'load': stress rate yy = nan: must be finite");
  bad = good;
  bad.controls.spin[2] = nan;
  EXPECT_EQ(refused(bad), "stage 'load': spin yz = nan: must be finite");
  bad = good;
  bad.controls.axes(0, 0) = 2;
  EXPECT_EQ(refused(bad), "stage 'load': axes = 3: is how far they are from a rotation, must be 0");
}

TEST(BadPath, OptionsAreRefusedWithTheirValue) {
  PathPointOf<Newtonian> point{fluid, fluid.density};
  const auto refused = [&](const PathOptions& options) {
    return message_of<InputError>([&] { drive(point, {}, options); });
  };

  EXPECT_EQ(refused({.tolerance = nan}), "path: tolerance = nan: must lie between 0 and 1");
  EXPECT_EQ(refused({.max_iterations = 0}), "path: max_iterations = 0: must be at least 1");
}

TEST(BadPath, PressureIsRefusedWithItsValue) {
  const PathPointOf<Newtonian> point{fluid, fluid.density};
  const auto refused = [&](double pressure) {
    return message_of<InputError>([&] { static_cast<void>(density_at_pressure(point, pressure)); });
  };

  EXPECT_EQ(refused(-1), "path: pressure = -1 Pa: must be finite and at least 0");
  EXPECT_EQ(refused(nan), "path: pressure = nan Pa: must be finite and at least 0");
}

TEST(BadPath, LawIsRefusedWithItsParameter) {
  Newtonian bad = fluid;
  bad.bulk_modulus = -1;

  EXPECT_EQ(message_of<InputError>([&] { PathPointOf<Newtonian>(bad, 1000); }),
            "newtonian: bulk_modulus = -1 Pa: must be finite and above 0");
}

TEST(BadPath, InputIsRefusedWithItsColumn) {
  const auto refused = [](const auto& law, const auto& input) {
    return message_of<InputError>([&] { PathPointOf(law, law.density, input); });
  };
  using Grains = MuOfI::Input<double>;
  using Mixture = MixtureMuOfI::Input<double>;
  using Packing = Suspension::Input<double>;

  EXPECT_EQ(refused(typical<MuOfI>(), Grains{0}),
            "the law 'mu_of_i' reads grain_size = 0 m: must be finite and above 0");
  EXPECT_EQ(refused(typical<MuOfI>(), Grains{nan}),
            "the law 'mu_of_i' reads grain_size = nan m: must be finite and above 0");
  EXPECT_EQ(refused(typical<MixtureMuOfI>(), Mixture{1e-3, 1.5}),
            "the law 'mixture_mu_of_i' reads coarse_fraction = 1.5: must lie in [0, 1]");
  EXPECT_EQ(refused(typical<MixtureMuOfI>(), Mixture{1e-3, 1}), "no error");
  EXPECT_EQ(refused(typical<Suspension>(), Packing{1}),
            "the law 'suspension' reads maximum_packing = 1: must lie in (0, 1)");
}

}  // namespace
}  // namespace scree::rheology
