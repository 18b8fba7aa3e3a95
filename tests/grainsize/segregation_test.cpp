#include "column.hpp"
#include "every_closure.hpp"
#include "message_of.hpp"

#include <scree/grainsize/distribution.hpp>
#include <scree/grainsize/segregation.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace scree::grainsize {
namespace {

using test::Column;
using test::message_of;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A box of sites with masses, a drive and a mixture, none of them regular; some sites are empty.
template <int D>
struct Box {
  Box(const Lattice<D>& lattice_, std::size_t num_classes_) : lattice{lattice_}, num_classes{num_classes_} {
    std::mt19937 random{7};
    std::uniform_real_distribution<double> draw{0, 1};
    const auto n = static_cast<std::size_t>(lattice.num_sites());
    for (std::size_t i = 0; i < n; ++i) {
      masses.push_back(draw(random) < 0.2 ? 0 : draw(random));
      drive.push_back(draw(random));
      double sum = 0;
      for (std::size_t k = 0; k < num_classes; ++k) sum += fractions.emplace_back(draw(random));
      for (std::size_t k = 0; k < num_classes; ++k) fractions[i * num_classes + k] /= sum;
    }
  }

  /// sum_i m_i Phi_i^k of class k, in long double: the sum's own rounding is none of the scheme's.
  [[nodiscard]] double class_mass(std::size_t k) const {
    long double sum = 0;
    for (std::size_t i = 0; i < masses.size(); ++i) sum += masses[i] * fractions[i * num_classes + k];
    return static_cast<double>(sum);
  }

  Lattice<D> lattice;
  std::size_t num_classes;
  std::vector<double> masses;
  std::vector<double> drive;
  std::vector<double> fractions;
};

Lattice<2> square(Index n, Sites sites = Sites::cells) {
  return {.count = {n, n + 3},
          .spacing = Vector<2>{0.1, 0.07},
          .first = Vector<2>::Zero(),
          .is_periodic = {true, false},
          .sites = sites};
}

Lattice<3> cube() {
  return {.count = {5, 6, 7},
          .spacing = Vector<3>{0.1, 0.07, 0.2},
          .first = Vector<3>::Zero(),
          .is_periodic = {false, true, false},
          .sites = Sites::nodes};
}

SizeClasses sizes(std::size_t num_classes) {
  return num_classes == 1 ? SizeClasses{{1e-3}} : polydisperse(0.5e-3, 2e-3, num_classes).classes;
}

struct Extremes {
  double lowest = 1;
  double highest = 0;
  double sum_error = 0;
};

Extremes extremes(const std::vector<double>& fractions, std::size_t num_classes) {
  Extremes result;
  for (std::size_t begin = 0; begin < fractions.size(); begin += num_classes) {
    double sum = 0;
    for (std::size_t k = 0; k < num_classes; ++k) {
      const double phi = fractions[begin + k];
      result.lowest = std::min(result.lowest, phi);
      result.highest = std::max(result.highest, phi);
      sum += phi;
    }
    result.sum_error = std::max(result.sum_error, std::abs(sum - 1));
  }
  return result;
}

template <int D>
void expect_mass_and_bounds_kept(const Lattice<D>& lattice, std::size_t num_classes,
                                 const AnyClosure& closure, Symmetry symmetry = Symmetry::plane) {
  Box<D> box{lattice, num_classes};
  const Box<D> start = box;
  Segregation<D> segregation{sizes(num_classes),
                             {.closure = closure, .remixing = 1e-4, .symmetry = symmetry},
                             lattice,
                             Vector<D>::Unit(D - 1),
                             Threads{1}};

  const SegregationReport report = segregation.advance(box.masses, box.drive, box.fractions, 2);

  // Each stage rounds a site's fraction by a few round-offs of 1: two stages in every substep.
  const double rounding = 8 * report.substeps * round_off;
  for (std::size_t k = 0; k < num_classes; ++k) {
    EXPECT_NEAR(box.class_mass(k) / start.class_mass(k), 1, rounding) << num_classes << " classes";
  }
  const Extremes found = extremes(box.fractions, num_classes);
  EXPECT_GE(found.lowest, -1e-14);
  EXPECT_LE(found.highest, 1 + 1e-14);
  EXPECT_LE(found.sum_error, rounding);
  EXPECT_GT(report.substeps, 10);
  for (std::size_t i = 0; i < box.masses.size(); ++i) {
    if (box.masses[i] > 0) continue;
    for (std::size_t k = 0; k < num_classes; ++k) {
      EXPECT_EQ(box.fractions[i * num_classes + k], start.fractions[i * num_classes + k]);
    }
  }
}

TEST(Segregation, KeepsClassMassesBoundsAndEmptySites) {  // Eq. (M1), partly filled, every instance
  for (const std::size_t num_classes : {2U, 3U, 5U, 8U, 12U, 16U}) {
    expect_mass_and_bounds_kept(square(8), num_classes, ShearRate{0.01});
    expect_mass_and_bounds_kept(square(8, Sites::nodes), num_classes, ShearRate{0.01});
    expect_mass_and_bounds_kept(cube(), num_classes, ShearRate{0.01});
  }
}

TEST(EveryClosure, KeepsClassMassesBoundsAndEmptySites) {
  for (const AnyClosure& closure : test::every_closure()) expect_mass_and_bounds_kept(square(8), 3, closure);
}

TEST(EveryClosure, LeavesOneSizeExactlyAsItIs) {
  for (const AnyClosure& closure : test::every_closure()) {
    Box<2> box{square(6), 1};
    Segregation<2> segregation{
        sizes(1), {.closure = closure, .remixing = 1e-3}, box.lattice, Vector<2>::Unit(1), Threads{1}};

    segregation.advance(box.masses, box.drive, box.fractions, 1);

    for (const double phi : box.fractions) EXPECT_EQ(phi, 1);
  }
}

TEST(Segregation, UniformMixtureUnderAUniformDriveStays) {
  std::vector<double> masses(20, 1.0);
  std::vector<double> drive(20, 3.0);
  std::vector<double> fractions(40, 0.5);
  Segregation<1> segregation{sizes(2),
                             {.closure = ShearRate{0.05}, .remixing = 0.1},
                             Column::lattice(20),
                             Vector<1>::Zero(),
                             Threads{1}};

  segregation.advance(masses, drive, fractions, 10);

  EXPECT_EQ(fractions, std::vector<double>(40, 0.5));
}

TEST(Segregation, OfALayeredPlaneIsTheColumn) {  // 2D of equal columns = 1D, along either axis
  constexpr Index n = 40;
  Column column{SizeClasses{{0.5, 1}}, n};
  column.set([](double z, std::size_t k) { return k == 0 ? 0.3 * z * z : z - 0.3 * z * z; });
  const double dx = 1.0 / n;
  const Lattice<2> plane{.count = {n, 3},
                         .spacing = Vector<2>{dx, dx},
                         .first = Vector<2>::Zero(),
                         .is_periodic = {false, true}};
  std::vector<double> masses;
  std::vector<double> drive;
  std::vector<double> fractions;
  for (int row = 0; row < 3; ++row) {
    masses.insert(masses.end(), column.masses().begin(), column.masses().end());
    drive.insert(drive.end(), column.drive().begin(), column.drive().end());
    fractions.insert(fractions.end(), column.fractions().begin(), column.fractions().end());
  }
  Segregation<2> segregation{SizeClasses{{0.5, 1}}, Column::defaults(), plane, Vector<2>::Zero(), Threads{1}};

  const auto report = segregation.advance(masses, drive, fractions, 0.5);
  const auto report_column = column.advance(0.5);

  EXPECT_EQ(report.substeps, report_column.substeps);
  for (std::size_t i = 0; i < fractions.size(); ++i) {  // mass and area differ by powers of round-off only
    EXPECT_NEAR(fractions[i], column.fractions()[i % column.fractions().size()], 100 * round_off);
  }
}

Lattice<2> ring(Sites sites) {
  return {.count = {8, 11}, .spacing = Vector<2>{0.1, 0.07}, .first = Vector<2>::Zero(), .sites = sites};
}

TEST(Segregation, RoundAnAxisKeepsClassMassesBoundsAndEmptySites) {  // Eq. (M180), partly filled
  for (const std::size_t num_classes : {2U, 5U}) {
    expect_mass_and_bounds_kept(ring(Sites::cells), num_classes, ShearRate{0.01}, Symmetry::axial);
    expect_mass_and_bounds_kept(ring(Sites::nodes), num_classes, ShearRate{0.01}, Symmetry::axial);
  }
}

TEST(Segregation, RoundAnAxisIsTheColumnAtEveryRadius) {  // layers are the same at every radius
  constexpr Index n = 40;
  constexpr Index num_rings = 5;
  Column column{SizeClasses{{0.5, 1}}, n};
  column.set([](double z, std::size_t k) { return k == 0 ? 0.3 * z * z : z - 0.3 * z * z; });
  const Lattice<2> rings{
      .count = {num_rings, n}, .spacing = Vector<2>{1.0 / n, 1.0 / n}, .first = Vector<2>::Zero()};
  std::vector<double> masses;
  std::vector<double> drive;
  std::vector<double> fractions;
  for (std::size_t j = 0; j < n; ++j) {
    for (Index i = 0; i < num_rings; ++i) {
      masses.push_back(column.masses()[j] * middle_radius(rings, i));
      drive.push_back(column.drive()[j]);
      for (std::size_t k = 0; k < 2; ++k) fractions.push_back(column.fractions()[2 * j + k]);
    }
  }
  SegregationOptions options = Column::defaults();
  options.symmetry = Symmetry::axial;
  Segregation<2> segregation{SizeClasses{{0.5, 1}}, options, rings, Vector<2>::Zero(), Threads{1}};

  segregation.advance(masses, drive, fractions, 0.5);
  column.advance(0.5);

  for (std::size_t i = 0; i < fractions.size(); ++i) {  // as of a layered plane
    const std::size_t layer = i / (2 * num_rings);
    EXPECT_NEAR(fractions[i], column.fractions()[2 * layer + i % 2], 100 * round_off);
  }
}

/// Two sites that remix for a time so short that the change is D dt A_f rho_f (Phi_2 - Phi_1)/h over the
/// mass, up to its own decay meanwhile. The lighter one, per volume, is the inner one or the outer one.
TEST(Segregation, RoundAnAxisExchangesThroughTheAreaOfTheRadius) {  // Eq. (M180)
  constexpr double h = 0.5;
  constexpr double dt = 1e-5;
  for (const Sites sites : {Sites::cells, Sites::nodes}) {
    const Lattice<1> lattice{
        .count = {2}, .spacing = Vector<1>{h}, .first = Vector<1>::Zero(), .sites = sites};
    for (const double density : {0.3, 3.0}) {  // of the outer one, over that of the inner one
      const std::vector<double> masses{middle_radius(lattice, 0) * lattice.volume({0}),
                                       density * middle_radius(lattice, 1) * lattice.volume({1})};
      std::vector<double> fractions{0.2, 0.8, 0.6, 0.4};
      Segregation<1> segregation{sizes(2),
                                 {.closure = ShearRate{0}, .remixing = 1, .symmetry = Symmetry::axial},
                                 lattice,
                                 Vector<1>::Zero(),
                                 Threads{1}};

      segregation.advance(masses, std::vector<double>{0, 0}, fractions, dt);

      const double passed = dt * radius_above(lattice, 0) * std::min(1.0, density) / h;
      const double decay = passed * (1 / masses[0] + 1 / masses[1]);
      for (const std::size_t site : {0U, 1U}) {
        const double change = passed * 0.4 / masses[site];
        EXPECT_NEAR(std::abs(fractions[2 * site] - (site == 0 ? 0.2 : 0.6)), change, decay * change);
      }
    }
  }
}

/// Largest error of Phi = 1/2 + 0.4 J_0(k r) exp(-D k^2 t), J_1(k) = 0, in a disk of radius 1 that remixes
/// until half of it is left.
double error_of_disk(Index num_cells) {
  constexpr double k = 3.8317059702075125;
  const double h = 1 / static_cast<double>(num_cells);
  const Lattice<1> lattice{.count = {num_cells}, .spacing = Vector<1>{h}, .first = Vector<1>::Zero()};
  std::vector<double> masses;
  std::vector<double> fractions;
  for (Index i = 0; i < num_cells; ++i) {
    masses.push_back(middle_radius(lattice, i) * h);
    const double phi = 0.5 + 0.4 * std::cyl_bessel_j(0, k * middle_radius(lattice, i));
    fractions.insert(fractions.end(), {phi, 1 - phi});
  }
  Segregation<1> segregation{sizes(2),
                             {.closure = ShearRate{0}, .remixing = 1, .symmetry = Symmetry::axial},
                             lattice,
                             Vector<1>::Zero(),
                             Threads{1}};
  segregation.advance(masses, std::vector<double>(masses.size(), 0.0), fractions, std::log(2.0) / (k * k));
  double error = 0;
  for (Index i = 0; i < num_cells; ++i) {
    const double exact = 0.5 + 0.2 * std::cyl_bessel_j(0, k * middle_radius(lattice, i));
    error = std::max(error, std::abs(fractions[2 * static_cast<std::size_t>(i)] - exact));
  }
  return error;
}

TEST(Segregation, RemixesADiskWithSecondOrder) {  // Eqs. (G5), (M180)
  EXPECT_GE(std::log2(error_of_disk(16) / error_of_disk(32)), 1.9);
  EXPECT_GE(std::log2(error_of_disk(32) / error_of_disk(64)), 1.9);
}

TEST(Segregation, RefusesAPeriodicRadius) {
  EXPECT_EQ(message_of([] {
              Segregation<2>(sizes(2), {.closure = ShearRate{1}, .symmetry = Symmetry::axial}, square(4),
                             Vector<2>::Zero(), Threads{1});
            }),
            "Segregation: axis 0 is the radius of a flow round an axis and cannot be periodic");
}

TEST(Segregation, GravityLiftsTheCoarseWhicheverWayItPoints) {
  constexpr std::size_t n = 20;
  for (const double down : {-1.0, 1.0}) {
    std::vector<double> masses(n, 1.0);
    std::vector<double> drive(n, 2.0);
    std::vector<double> fractions(2 * n, 0.5);
    Segregation<1> segregation{
        sizes(2), {.closure = Gravity{0.5}}, Column::lattice(n), Vector<1>{down}, Threads{1}};

    segregation.advance(masses, drive, fractions, 5);

    const double coarse_at_low_end = fractions[1];
    const double coarse_at_high_end = fractions[2 * n - 1];
    EXPECT_NEAR(coarse_at_low_end, down < 0 ? 0 : 1, 1e-12);  // long after W t/H = 2.2: tails only
    EXPECT_NEAR(coarse_at_high_end, down < 0 ? 1 : 0, 1e-12);
  }
}

TEST(Segregation, HasTheSameBitsForAnyNumberOfThreads) {
  Box<2> one{square(40), 5};
  Box<2> two = one;
  Box<2> three = one;
  const auto run = [](Box<2>& box, int num_threads) {
    Segregation<2> segregation{sizes(5),
                               {.closure = ShearRate{0.01}, .remixing = 1e-5},
                               box.lattice,
                               Vector<2>::Zero(),
                               Threads{num_threads}};
    segregation.advance(box.masses, box.drive, box.fractions, 0.5);
  };

  run(one, 1);
  run(two, 2);
  run(three, 3);

  EXPECT_EQ(one.fractions, two.fractions);
  EXPECT_EQ(one.fractions, three.fractions);
}

TEST(Segregation, SliverOfMassDoesNotShortenTheStep) {  // Eq. (G18)
  Column column{SizeClasses{{0.5, 1}}, 50};
  column.set([](double z, std::size_t) { return z / 2; });
  Segregation<1> segregation{SizeClasses{{0.5, 1}}, Column::defaults(), Column::lattice(50),
                             Vector<1>::Zero(), Threads{1}};
  const double full = segregation.stable_time_step(column.masses(), column.drive(), column.fractions());
  column.masses().back() *= 1e-3;

  const double with_sliver =
      segregation.stable_time_step(column.masses(), column.drive(), column.fractions());

  EXPECT_GE(with_sliver, full * (1 - 4 * round_off));
}

TEST(Segregation, StableStepIsHalfACellOverTheSpeed) {  // Eqs. (G10), (G18)
  Column column{SizeClasses{{0.5, 1}}, 50};
  column.set([](double z, std::size_t) { return z / 2; });
  Segregation<1> segregation{SizeClasses{{0.5, 1}}, Column::defaults(), Column::lattice(50),
                             Vector<1>::Zero(), Threads{1}};

  const double dt = segregation.stable_time_step(column.masses(), column.drive(), column.fractions());

  const double speed = 1 / 1.5 / 0.5 - 1;                       // s_h = 2/3 m, s_min = 1/2 m, B = 1 m/s
  EXPECT_NEAR(dt, 0.5 * 0.02 / speed, 0.02 * 100 * round_off);  // drive differences lose a factor of 50
}

/// The drive rises by 1/50 at each face, by four times as much at that between sites 17 and 18.
TEST(Segregation, NamesTheSiteThatBoundsItsStep) {  // Eq. (G18)
  const SizeClasses three{{0.5, 0.7, 1}};           // one fewer than the loops have room for
  Column column{three, 50};
  column.set([](double z, std::size_t) { return z / 3; });
  for (std::size_t i = 18; i < 50; ++i) column.drive()[i] += 0.06;
  Segregation<1> segregation{three, Column::defaults(), Column::lattice(50), Vector<1>::Zero(), Threads{1}};
  const auto site = [&] {
    return segregation.limiting_site(column.masses(), column.drive(), column.fractions());
  };

  EXPECT_EQ(site(), 17);  // both sides are alike: the first
  column.masses()[18] /= 2;
  EXPECT_EQ(site(), 18);  // half of it passes in the same time
  column.drive().assign(50, 1);
  EXPECT_EQ(site(), std::nullopt);
}

TEST(Segregation, NamesTheSameSiteForAnyNumberOfThreads) {
  Box<2> box{square(40), 5};
  const auto site = [&](int num_threads) {
    Segregation<2> segregation{sizes(5),
                               {.closure = ShearRate{0.01}, .remixing = 1e-5},
                               box.lattice,
                               Vector<2>::Zero(),
                               Threads{num_threads}};
    return segregation.limiting_site(box.masses, box.drive, box.fractions);
  };

  ASSERT_TRUE(site(1));
  EXPECT_GT(box.masses[static_cast<std::size_t>(*site(1))], 0);
  for (const int num_threads : {2, 3}) EXPECT_EQ(site(num_threads), site(1)) << num_threads;
}

TEST(Segregation, KeepsMassesBoundsAndSumsOverAHundredThousandSteps) {
  const std::size_t num_classes = 5;
  Column column{polydisperse(0.2, 1, num_classes).classes, 40};
  column.set([](double z, std::size_t) { return z / 5; });
  std::array<double, num_classes> before{};
  for (std::size_t k = 0; k < num_classes; ++k) before[k] = column.class_mass(k);
  int num_steps = 0;

  while (num_steps < 100000) {  // to and fro, so that there is always something to move
    num_steps += column.advance(10).substeps;
    for (double& drive : column.drive()) drive = -drive;
  }

  for (std::size_t k = 0; k < num_classes; ++k) EXPECT_NEAR(column.class_mass(k) / before[k], 1, 1e-12);
  const Extremes found = extremes(column.fractions(), num_classes);
  EXPECT_GE(found.lowest, -1e-14);
  EXPECT_LE(found.highest, 1 + 1e-14);
  EXPECT_LE(found.sum_error, 1e-13);
}

TEST(Segregation, RefusesOptionsThatCannotBe) {
  const auto fault = [](const SegregationOptions& options, const Vector<2>& gravity) {
    return message_of([&] { Segregation<2>(sizes(2), options, square(4), gravity, Threads{1}); });
  };
  const Vector<2> none = Vector<2>::Zero();

  EXPECT_EQ(fault({.closure = ShearRate{1}, .remixing = -1}, none),
            "Segregation: the remixing is -1 m^2/s, but must be zero or positive, and finite");
  EXPECT_EQ(fault({.closure = ShearRate{1}, .remixing = nan}, none),
            "Segregation: the remixing is nan m^2/s, but must be zero or positive, and finite");
  EXPECT_EQ(fault({.closure = ShearRate{1}, .cfl = 0.6}, none),
            "Segregation: the CFL number is 0.6, but must lie in (0, 0.5]");
  EXPECT_EQ(fault({.closure = ShearRate{1}, .cfl = 0}, none),
            "Segregation: the CFL number is 0, but must lie in (0, 0.5]");
  EXPECT_EQ(fault({.closure = Gravity{1}}, none),
            "Segregation: the closure gravity needs a direction of gravity, but there is none");
  EXPECT_EQ(fault({.closure = Gravity{1}}, Vector<2>{0, -9.81}),
            "Segregation: the direction of gravity has the length 9.81, but must be a unit vector or zero");
  EXPECT_EQ(
      message_of([&] { Segregation<2>(sizes(17), {.closure = ShearRate{1}}, square(4), none, Threads{1}); }),
      "Segregation: there are 17 size classes, but at most 16 are possible");
}

TEST(Segregation, RefusesArraysThatDoNotFit) {
  Box<1> box{Column::lattice(10), 2};
  Segregation<1> segregation{sizes(2), {.closure = ShearRate{1}}, box.lattice, Vector<1>::Zero(), Threads{1}};
  const auto fault = [&](std::size_t num_masses, std::size_t num_drives, std::size_t num_fractions,
                         double dt) {
    std::vector<double> masses(num_masses, 1.0);
    std::vector<double> drive(num_drives);
    std::vector<double> fractions(num_fractions, 0.5);
    return message_of([&] { segregation.advance(masses, drive, fractions, dt); });
  };

  EXPECT_EQ(fault(9, 10, 20, 1), "Segregation: 10 masses are needed, but 9 are given");
  EXPECT_EQ(fault(10, 11, 20, 1), "Segregation: 10 drives are needed, but 11 are given");
  EXPECT_EQ(fault(10, 10, 10, 1), "Segregation: 20 fractions are needed, but 10 are given");
  EXPECT_EQ(fault(10, 10, 20, -1), "Segregation: the step is -1 s, but must be zero or positive, and finite");
  EXPECT_EQ(fault(10, 10, 20, nan),
            "Segregation: the step is nan s, but must be zero or positive, and finite");
}

TEST(Segregation, StopsAtADriveThatIsNotANumberAndLeavesTheFractions) {
  Column column{SizeClasses{{0.5, 1}}, 10};
  column.set([](double z, std::size_t) { return z / 2; });
  const std::vector<double> before = column.fractions();
  column.drive()[4] = nan;

  std::string message;
  try {
    column.advance(1);
  } catch (const RunError& error) {
    message = error.what();
  }

  EXPECT_EQ(message, "transport: the rate of change is not finite at site (3), position (0.35) m");
  EXPECT_EQ(column.fractions(), before);
}

TEST(Segregation, DoesNotReadTheDriveOfEmptySites) {
  Column column{SizeClasses{{0.5, 1}}, 10};
  column.set([](double z, std::size_t) { return z / 2; });
  column.masses()[9] = 0;
  column.drive()[9] = nan;
  const double before = column.fraction(9, 0);

  EXPECT_NO_THROW(column.advance(1));
  EXPECT_EQ(column.fraction(9, 0), before);
}

}  // namespace
}  // namespace scree::grainsize
