#include "bodies.hpp"
#include "messages.hpp"

#include <scree/mpm/limiting_point.hpp>
#include <scree/mpm/stress_update.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace scree::mpm {
namespace {

/// Viscosity in proportion to the grain size, and a memory of how far it was sheared.
struct Coarse {
  static constexpr std::string_view name = "coarse";
  template <class Real>
  struct Input {
    Real grain_size;
  };
  static constexpr std::array<InputColumn, 1> inputs{{{"grain_size", "m", 1e-3}}};
  template <class Real>
  struct State {
    Real shear_strain;
  };
  static constexpr std::array<StateColumn, 1> states{{{"shear_strain", "-", 0.25}}};

  template <class Real>
  [[nodiscard]] Response<Real, State<Real>> update(const Deformation<Real>& deformation,
                                                   const Input<Real>& input, const State<Real>& old,
                                                   Real dt) const noexcept {
    const Real pressure = deformation.density - 1000;
    const Tensor<Real> viscous =
        2 * input.grain_size * deviator(symmetric_part(deformation.velocity_gradient));
    return {viscous - isotropic(pressure),
            {old.shear_strain + dt * shear_rate(deformation.velocity_gradient)}};
  }
  [[nodiscard]] Stiffness<double> stiffness(const Deformation<double>& /*deformation*/,
                                            const Input<double>& input,
                                            const State<double>& /*state*/) const noexcept {
    return {1, input.grain_size};
  }
};
static_assert(ConstitutiveLaw<Coarse>);

/// A law with a kernel of its own, which says what it was called for; or none for the baseline.
struct Kernelled : Coarse {
  static constexpr std::string_view name = "kernelled";

  static BlockStiffness run(const Kernelled& /*law*/, const LawBlock<Kernelled>& block, double dt) noexcept {
    std::fill_n(block.stress[0], block.num_points, dt);
    BlockStiffness report;
    report.wave_speed = static_cast<double>(block.num_points);
    report.unsolved = 0.5;
    report.unsolved_point = 3;
    return report;
  }
  [[nodiscard]] friend BlockKernel<Kernelled> block_kernel(const Kernelled& /*law*/,
                                                           InstructionSet set) noexcept {
    return set == InstructionSet::baseline ? nullptr : &run;
  }
};

/// A law with a form for plane flow, which counts its steps twice.
struct Counting : Fluid {
  static constexpr std::string_view name = "counting";
  template <class Real>
  struct State {
    Real steps, steps_along_z;
  };
  template <class Real>
  struct PlaneState {
    Real steps;
  };
  static constexpr std::array<StateColumn, 2> states{{{"steps", "-"}, {"steps_along_z", "-"}}};
  static constexpr std::array<std::size_t, 1> plane_states{0};

  template <class Real>
  [[nodiscard]] Response<Real, State<Real>> update(const Deformation<Real>& /*deformation*/,
                                                   const Input<Real>& /*input*/, const State<Real>& old,
                                                   Real /*dt*/) const noexcept {
    return {{}, {old.steps + 1, old.steps_along_z + 1}};
  }
  template <class Real>
  [[nodiscard]] Response<Real, PlaneState<Real>> update(const Deformation<Real>& /*deformation*/,
                                                        const Input<Real>& /*input*/,
                                                        const PlaneState<Real>& old,
                                                        Real /*dt*/) const noexcept {
    return {{}, {old.steps + 2}};
  }
  template <class Real, class AnyState>
  [[nodiscard]] Stiffness<Real> stiffness(const Deformation<Real>& /*deformation*/,
                                          const Input<Real>& /*input*/,
                                          const AnyState& /*state*/) const noexcept {
    return {1, 0};
  }
};
static_assert(HasPlaneForm<Counting> && !HasPlaneForm<Coarse>);

/// A law that never bears a pressure.
struct Powder : Fluid {
  static constexpr std::string_view name = "powder";
};

/// Some sheared, squeezed points of unlike grain size under `Coarse`.
template <int D, int V>
struct Sheared {
  Sheared() {
    particles.resize(8);
    grain_size = particles.add_column({"grain_size", "s_a", "m"}, 1);
    fill_at_random(particles.velocity_gradient, 2.0);
    for (Index p = 0; p < 8; ++p) {
      particles.mass.component(0)[p] = 1;
      particles.density.component(0)[p] = 1000 + static_cast<double>(p);
      particles.column(grain_size).component(0)[p] = 1 + static_cast<double>(p) / 8;
    }
  }
  [[nodiscard]] ParticleBlock<D> all() const { return {{}, 0, 8}; }
  Particles<D, V> particles;
  std::size_t grain_size;
};

template <int D, int V>
[[nodiscard]] std::array<double, 2> steps_counted() {
  Particles<D, V> particles;
  particles.resize(pack_size);
  StressUpdateBy<D, V, Counting> update{{}, particles};
  update.apply(particles, {{}, 0, pack_size}, 1e-3);
  const auto count = [&](std::string_view name) {
    return particles.column(particles.find_column(name, "the test")).component(0)[pack_size - 1];
  };
  return {count("steps"), count("steps_along_z")};
}

TEST(StressUpdate, RunsAPlaneFlowByThePlaneFormOfALaw) {
  EXPECT_EQ((steps_counted<1, 1>()), (std::array<double, 2>{2, 0}));
  EXPECT_EQ((steps_counted<2, 2>()), (std::array<double, 2>{2, 0}));
  EXPECT_EQ((steps_counted<2, 3>()), (std::array<double, 2>{1, 1}));
  EXPECT_EQ((steps_counted<3, 3>()), (std::array<double, 2>{1, 1}));
}

TEST(StressUpdate, NamesThePointWhoseMemoryIsNotThatOfAPlane) {
  Sheared<2, 2> sheared;
  const StressUpdateBy<2, 2, Counting> update{{}, sheared.particles};
  const std::size_t column = sheared.particles.find_column("steps_along_z", "the test");
  sheared.particles.column(column).component(0)[3] = 2;
  sheared.particles.id.component(0)[3] = 12;

  const auto complaint = message_of<InputError>([&] { update.require_memory(sheared.particles); });

  EXPECT_EQ(complaint,
            "the law 'counting' reads steps_along_z (which a flow in a plane lacks) = 2 of material point 12 "
            "at (0, 0) m: must be 0");
}

TEST(StressUpdate, NamesTheColumnThatALawMisses) {
  Particles<2> particles;

  EXPECT_EQ(message_of<InputError>([&] { StressUpdateBy<2, 2, Coarse>({}, particles); }),
            "the law 'coarse' needs the column 'grain_size', which no part of this run provides");
}

TEST(StressUpdate, NamesTheColumnThatIsInAnotherUnit) {
  Particles<2> particles;
  particles.add_column({"grain_size", "s_a", "mm"}, 1);

  EXPECT_EQ(message_of<InputError>([&] { StressUpdateBy<2, 2, Coarse>({}, particles); }),
            "the law 'coarse' reads the column 'grain_size' in m, but it is in mm");
}

TEST(StressUpdate, NamesTheFirstPointWhoseInputIsOutOfItsRange) {
  Sheared<2, 2> sheared;
  for (const Index p : {3, 5}) sheared.particles.column(sheared.grain_size).component(0)[p] = 0;
  sheared.particles.id.component(0)[3] = 12;
  sheared.particles.position.component(0)[3] = 0.5;
  sheared.particles.position.component(1)[3] = 1;
  const auto complaint = [&] {
    return message_of<InputError>([&] { StressUpdateBy<2, 2, Coarse>({}, sheared.particles); });
  };

  EXPECT_EQ(complaint(),
            "the law 'coarse' reads grain_size = 0 m of material point 12 at (0.5, 1) m: must be finite and "
            "above 0");
  sheared.particles.column(sheared.grain_size).component(0)[3] = std::nan("");
  EXPECT_EQ(complaint(),
            "the law 'coarse' reads grain_size = nan m of material point 12 at (0.5, 1) m: must be finite "
            "and above 0");
}

TEST(StressUpdate, StartsTheMemoryOfALawAtItsInitialValue) {
  Sheared<2, 2> sheared;

  const StressUpdateBy<2, 2, Coarse> stress{{}, sheared.particles};

  const Column& strain = sheared.particles.column(sheared.particles.find_column("shear_strain", "a test"));
  EXPECT_EQ(strain.quantity(), (Quantity{"shear_strain", "shear_strain", "-"}));
  for (const double value : strain.values()) EXPECT_EQ(value, 0.25);
}

TEST(StressUpdate, GivesALawWithMemoryItsColumn) {
  Sheared<2, 2> sheared;
  const StressUpdateBy<2, 2, Coarse> stress{{}, sheared.particles};

  for (int n = 0; n < 2; ++n) stress.apply(sheared.particles, sheared.all(), 0.5);

  const std::size_t strain = sheared.particles.find_column("shear_strain", "a test");
  for (Index p = 0; p < 8; ++p) {
    // From the initial value on, twice half a second.
    const double expected = 0.25 + shear_rate(velocity_gradient_of(sheared.particles, p));
    EXPECT_NEAR(sheared.particles.column(strain).component(0)[p], expected, 2 * round_off * expected);
  }
}

TEST(StressUpdate, CostsNoColumnWithoutMemory) {
  Particles<2> particles;
  const std::size_t bare = particles.bytes_per_particle();

  const StressUpdateBy<2, 2, Fluid> stress{dust, particles};

  EXPECT_EQ(particles.bytes_per_particle(), bare);
}

TEST(StressUpdate, EmbedsAColumnUnderShearInPlaneStrain) {
  Sheared<1, 2> column;
  Sheared<2, 2> plane;
  for (Index p = 0; p < 8; ++p) {
    for (int i = 0; i < 2; ++i) {
      plane.particles.velocity_gradient.component(i)[p] = column.particles.velocity_gradient.component(i)[p];
      plane.particles.velocity_gradient.component(i + 2)[p] = 0;
    }
  }
  const StressUpdateBy<1, 2, Coarse> of_column{{}, column.particles};
  const StressUpdateBy<2, 2, Coarse> of_plane{{}, plane.particles};

  of_column.apply(column.particles, column.all(), 0.1);
  of_plane.apply(plane.particles, plane.all(), 0.1);

  for (Index p = 0; p < 8; ++p) {
    for (int i = 0; i < 2; ++i) {
      EXPECT_EQ(column.particles.stress.component(i)[p], plane.particles.stress.component(i)[p]);
    }
  }
}

TEST(StressUpdate, ReportsTheStiffestPoint) {
  Sheared<2, 2> sheared;
  const StressUpdateBy<2, 2, Coarse> stress{{}, sheared.particles};
  double expected = 0;
  for (Index p = 0; p < 8; ++p) {
    expected = std::max(expected, sheared.particles.column(sheared.grain_size).component(0)[p] /
                                      sheared.particles.density.component(0)[p]);
  }

  EXPECT_EQ(stress.apply(sheared.particles, sheared.all(), 0.1).kinematic_viscosity, expected);
  EXPECT_EQ(stress.stiffness(sheared.particles, 0, 8).kinematic_viscosity, expected);
  EXPECT_EQ(stress.stiffness(sheared.particles, 0, 8).wave_speed, 1);
}

TEST(LimitingPoint, IsTheOneWhoseRateIsTheLargest) {
  const auto grid = cube<2>(4, 0.25, false);
  auto particles = scattered<2>(grid, 5, 0);
  fill_at_random(particles.velocity, 0);
  particles.add_column({"grain_size", "d", "m"}, 1);
  Column& size = particles.column(particles.find_column("grain_size", "the test"));
  std::ranges::fill(size.values(), 1e-3);
  size.component(0)[2] = 4e-3;
  size.component(0)[4] = 5e-3;
  particles.mass.component(0)[4] = 0;        // only fills a block
  particles.velocity.component(0)[3] = 0.3;  // and sound is as fast everywhere
  particles.velocity.component(1)[1] = -0.4;
  const StressUpdateBy<2, 2, Coarse> stress{{}, particles};
  const auto limiting = [&](Limit limit) { return limiting_point(particles, stress, grid, limit); };

  EXPECT_EQ(limiting(Limit::viscous), 2);
  EXPECT_EQ(limiting(Limit::advective), 1);
  EXPECT_EQ(limiting(Limit::acoustic), 1);
  EXPECT_EQ(limiting(Limit::relaxation), std::nullopt);  // no memory of this law binds
  EXPECT_EQ(limiting(Limit::maximum), std::nullopt);
  EXPECT_EQ(limiting(Limit::output), std::nullopt);
  particles.velocity.component(0)[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(limiting(Limit::acoustic), 3);
}

TEST(StressUpdate, RunsALawWithoutAKernelPointByPoint) {
  Sheared<2, 2> sheared;
  const StressUpdateBy<2, 2, Coarse> stress{{}, sheared.particles};

  stress.apply(sheared.particles, sheared.all(), 0.1);

  for (Index p = 0; p < 8; ++p) {
    const Tensor<double> gradient = velocity_gradient_of(sheared.particles, p);
    const double size = sheared.particles.column(sheared.grain_size).component(0)[p];
    const auto alone =
        Coarse{}.update({gradient, sheared.particles.density.component(0)[p]}, {size}, {0.25}, 0.1);
    for (int c = 0; c < 4; ++c) {
      const double expected = alone.stress(static_cast<std::size_t>(c % 2), static_cast<std::size_t>(c / 2));
      // Products and sums may be contracted in one of the two: a few roundings of parts below 20 Pa.
      EXPECT_NEAR(sheared.particles.stress.component(c)[p], expected, 8 * round_off * 20);
    }
  }
}

TEST(StressUpdate, LeavesABlockToTheKernelThatALawHas) {
  Sheared<2, 2> sheared;
  sheared.particles.resize(24);
  std::ranges::fill(sheared.particles.column(sheared.grain_size).values(), 1);
  const StressUpdateBy<2, 2, Kernelled> stress{{}, sheared.particles, InstructionSet::x86_64_v3};

  const BlockStiffness report = stress.apply(sheared.particles, {{}, 8, 24}, 0.1);

  EXPECT_EQ(report.wave_speed, 16);
  EXPECT_EQ(report.unsolved, 0.5);
  EXPECT_EQ(report.unsolved_point, 8 + 3);  // of all points
  for (Index p = 0; p < 24; ++p) {
    EXPECT_EQ(sheared.particles.stress.component(0)[p], p < 8 ? 0 : 0.1);
    EXPECT_EQ(sheared.particles.stress.component(1)[p], 0);
  }
}

TEST(StressUpdate, RunsALawWithoutAKernelForASetPointByPoint) {
  Sheared<2, 2> one;
  Sheared<2, 2> other;
  const StressUpdateBy<2, 2, Kernelled> stress{{}, one.particles, InstructionSet::baseline};
  const StressUpdateBy<2, 2, Coarse> generic{{}, other.particles};

  stress.apply(one.particles, one.all(), 0.1);
  generic.apply(other.particles, other.all(), 0.1);

  EXPECT_TRUE(std::ranges::equal(one.particles.stress.values(), other.particles.stress.values()));
}

TEST(StressUpdate, TellsThePressureAndChangesNothing) {
  Sheared<2, 2> sheared;
  const StressUpdateBy<2, 2, Coarse> stress{{}, sheared.particles};
  std::vector<double> pressure(8);

  stress.pressure(sheared.particles, pressure);

  for (Index p = 0; p < 8; ++p) {
    // The trace of the viscous part is zero up to roundings of its three components, of a few Pa.
    EXPECT_NEAR(pressure[static_cast<std::size_t>(p)], static_cast<double>(p), 100 * round_off);
  }
  EXPECT_EQ(largest(sheared.particles.stress), 0);
  for (const double strain :
       sheared.particles.column(sheared.particles.find_column("shear_strain", "a test")).values()) {
    EXPECT_EQ(strain, 0.25);
  }
}

TEST(StressUpdate, FindsTheDensityThatBearsAPressure) {
  Particles<1> particles;
  particles.resize(1);
  particles.density.component(0)[0] = 1000;
  const StressUpdateBy<1, 1, Fluid> stress{{.bulk_modulus = 1e6, .reference_density = 1000, .viscosity = 0},
                                           particles};

  for (const double pressure : {0.0, 1.0, 1e4}) {
    const double expected = 1000 * (1 + pressure / 1e6);
    EXPECT_NEAR(stress.density_at(particles, 0, pressure), expected, 8 * round_off * expected);
  }
}

TEST(StressUpdate, NamesTheLawThatCannotBearAPressure) {
  Particles<1> particles;
  particles.resize(1);
  particles.density.component(0)[0] = 1000;
  const StressUpdateBy<1, 1, Powder> stress{{dust}, particles};

  EXPECT_EQ(message_of<RunError>([&] { static_cast<void>(stress.density_at(particles, 0, 10)); }),
            "the law 'powder' has no density at which its pressure is 10.000000 Pa");
}

}  // namespace
}  // namespace scree::mpm
