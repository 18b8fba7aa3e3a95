#include "bodies.hpp"
#include "schemes.hpp"

#include <scree/mpm/carried_cells.hpp>
#include <scree/mpm/cell_sort.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <tuple>
#include <vector>

namespace scree::mpm {
namespace {

constexpr Threads one_thread{1};
constexpr std::size_t num_classes = 3;

/// Points with unlike mixtures in unlike places.
template <int D>
struct Mixture {
  explicit Mixture(Index cells = 4, Index num_points = 150) : grid{cube<D>(cells, 0.1, false)} {
    particles = scattered<D>(grid, num_points, 0);
    column = particles.add_column({"size_fractions", "phi", "-"}, num_classes);
    std::mt19937 random{17};
    std::uniform_real_distribution<double> draw{0, 1};
    for (Index p = 0; p < num_points; ++p) set(p, {draw(random), draw(random), draw(random)});
    blocks = cell_sort(particles, grid, 0, one_thread);
  }

  void set(Index p, std::array<double, num_classes> shares) {
    const double sum = shares[0] + shares[1] + shares[2];
    for (std::size_t k = 0; k < num_classes; ++k) fraction(p, k) = shares[k] / sum;
  }
  [[nodiscard]] double& fraction(Index p, std::size_t k) {
    return particles.column(column).component(static_cast<int>(k))[p];
  }
  [[nodiscard]] std::vector<CarriedField> fields() const {
    std::vector<CarriedField> all;
    for (std::size_t k = 0; k < num_classes; ++k)
      all.push_back({&particles.column(column), static_cast<int>(k)});
    return all;
  }
  /// sum_p m_p Phi_p^k, in long double: the sum's own rounding is none of the scheme's.
  [[nodiscard]] double class_mass(std::size_t k) {
    long double sum = 0;
    for (Index p = 0; p < particles.size(); ++p) sum += particles.mass.component(0)[p] * fraction(p, k);
    return static_cast<double>(sum);
  }
  [[nodiscard]] double mass() const {
    double sum = 0;
    for (const double m : particles.mass.values()) sum += m;
    return sum;
  }
  /// Smallest and largest fraction on any point, and the largest distance of a sum from one.
  struct Bounds {
    double smallest = 1;
    double largest = 0;
    double sum_error = 0;
  };
  [[nodiscard]] Bounds bounds() {
    Bounds result;
    for (Index p = 0; p < particles.size(); ++p) {
      double sum = 0;
      for (std::size_t k = 0; k < num_classes; ++k) {
        result.smallest = std::min(result.smallest, fraction(p, k));
        result.largest = std::max(result.largest, fraction(p, k));
        sum += fraction(p, k);
      }
      result.sum_error = std::max(result.sum_error, std::abs(sum - 1));
    }
    return result;
  }

  CartesianGrid<D> grid;
  Particles<D> particles;
  std::size_t column = 0;
  ParticleBlocks<D> blocks;
};

/// Masses and means of all classes on the sites.
template <int D>
struct OnSites {
  OnSites(const Mixture<D>& mixture, const CarriedCells<D, D>& carried)
      : masses(static_cast<std::size_t>(carried.lattice().num_sites())), means(masses.size() * num_classes) {
    carried.to_sites(mixture.particles, mixture.blocks, mixture.fields(), masses, means, one_thread);
  }
  std::vector<double> masses;
  std::vector<double> means;
};

/// Other means: each a random part of the way to a random mixture.
std::vector<double> changed(const std::vector<double>& means, const std::vector<double>& masses) {
  std::mt19937 random{19};
  std::uniform_real_distribution<double> draw{0, 1};
  std::vector<double> result = means;
  for (std::size_t site = 0; site < masses.size(); ++site) {
    std::array<double, num_classes> goal{draw(random), draw(random), draw(random)};
    const double sum = goal[0] + goal[1] + goal[2];
    const double part = draw(random);
    if (!(masses[site] > 0)) continue;
    for (std::size_t k = 0; k < num_classes; ++k) {
      double& mean = result[site * num_classes + k];
      mean += part * (goal[k] / sum - mean);
    }
  }
  return result;
}

/// Calls test(CarriedCells) for cells and for nodes, these with every shape.
template <int D, class Test>
void on_all_sites(const CartesianGrid<D>& grid, Test&& test) {
  test(CarriedCells<D, D>{grid, Sites::cells, Linear{}});
  for (const AnyShape& shape : every<AnyShape>()) test(CarriedCells<D, D>{grid, Sites::nodes, shape});
}

template <class Dimension>
class CarriedOnSites : public ::testing::Test {
 protected:
  /// Roundings of a fraction on its way to the sites of the widest stencil and back.
  static constexpr double rounding = 10 * 27 * round_off;
};
TYPED_TEST_SUITE(CarriedOnSites, Dimensions);

TYPED_TEST(CarriedOnSites, GetTheMassOfThePoints) {  // Eq. (M21)
  const Mixture<TypeParam::value> mixture;
  on_all_sites(mixture.grid, [&](const auto& carried) {
    const OnSites sites{mixture, carried};

    double sum = 0;
    for (const double mass : sites.masses) sum += mass;
    const auto terms = static_cast<double>(mixture.particles.size());
    EXPECT_NEAR(sum, mixture.mass(), (this->rounding + 2 * terms * round_off) * mixture.mass());
  });
}

TYPED_TEST(CarriedOnSites, GetFractionsThatSumToOne) {
  const Mixture<TypeParam::value> mixture;
  on_all_sites(mixture.grid, [&](const auto& carried) {
    const OnSites sites{mixture, carried};

    for (std::size_t site = 0; site < sites.masses.size(); ++site) {
      const double* mean = sites.means.data() + site * num_classes;
      const auto terms = static_cast<double>(mixture.particles.size());  // summed on one site, at most
      EXPECT_NEAR(mean[0] + mean[1] + mean[2], sites.masses[site] > 0 ? 1 : 0, terms * round_off);
    }
  });
}

TYPED_TEST(CarriedOnSites, GiveBackTheClassMassThatTheyGain) {  // Eq. (M22), and (M23)
  for (const CarriedMap map : {CarriedMap::exchange, CarriedMap::increments}) {
    Mixture<TypeParam::value> mixture;
    on_all_sites(mixture.grid, [&](auto carried) {
      const OnSites sites{mixture, carried};
      const auto goal = changed(sites.means, sites.masses);
      std::array<double, num_classes> expected{};
      for (std::size_t k = 0; k < num_classes; ++k) {
        long double gain = 0;
        for (std::size_t i = 0; i < sites.masses.size(); ++i) {
          gain += sites.masses[i] * (goal[i * num_classes + k] - sites.means[i * num_classes + k]);
        }
        expected[k] = mixture.class_mass(k) + static_cast<double>(gain);
      }

      carried.to_points(mixture.blocks, mixture.particles, mixture.particles.column(mixture.column),
                        sites.means, goal, map, one_thread);

      const auto terms = static_cast<double>(mixture.particles.size());  // in the mean of one site
      for (std::size_t k = 0; k < num_classes; ++k) {
        EXPECT_NEAR(mixture.class_mass(k), expected[k],
                    (this->rounding + terms * round_off) * mixture.mass());
      }
    });
  }
}

TYPED_TEST(CarriedOnSites, KeepEveryPointWithinItsBounds) {  // Eq. (M22)
  Mixture<TypeParam::value> mixture;
  on_all_sites(mixture.grid, [&](auto carried) {
    const OnSites sites{mixture, carried};

    carried.to_points(mixture.blocks, mixture.particles, mixture.particles.column(mixture.column),
                      sites.means, changed(sites.means, sites.masses), CarriedMap::exchange, one_thread);

    const auto bounds = mixture.bounds();
    EXPECT_GE(bounds.smallest, -1e-14);
    EXPECT_LE(bounds.largest, 1 + 1e-14);
    EXPECT_LE(bounds.sum_error, 1e-13);
  });
}

TYPED_TEST(CarriedOnSites, MapAsThePaperDoesWhereThePointsAreAlike) {  // Eq. (M22) = Eq. (M23) there
  Mixture<TypeParam::value> exchanged;
  for (Index p = 0; p < exchanged.particles.size(); ++p) exchanged.set(p, {2, 5, 3});
  auto incremented = exchanged;
  on_all_sites(exchanged.grid, [&](auto carried) {
    auto one = exchanged;
    auto other = incremented;
    const OnSites sites{one, carried};
    const auto goal = changed(sites.means, sites.masses);

    carried.to_points(one.blocks, one.particles, one.particles.column(one.column), sites.means, goal,
                      CarriedMap::exchange, one_thread);
    carried.to_points(other.blocks, other.particles, other.particles.column(other.column), sites.means, goal,
                      CarriedMap::increments, one_thread);

    const auto terms = static_cast<double>(one.particles.size());
    for (Index p = 0; p < one.particles.size(); ++p) {
      for (std::size_t k = 0; k < num_classes; ++k) {
        EXPECT_NEAR(one.fraction(p, k), other.fraction(p, k), this->rounding + terms * round_off);
      }
    }
  });
}

TYPED_TEST(CarriedOnSites, HaveTheSameBitsForAnyNumberOfThreads) {
  const Mixture<TypeParam::value> mixture{TypeParam::value == 2 ? 64 : 20, 2000};
  on_all_sites(mixture.grid, [&](auto carried) {
    const auto there_and_back = [&](int threads) {
      auto changing = mixture;
      std::vector<double> masses(OnSites{mixture, carried}.masses.size());
      std::vector<double> means(masses.size() * num_classes);
      carried.to_sites(changing.particles, changing.blocks, changing.fields(), masses, means, {threads});
      carried.to_points(changing.blocks, changing.particles, changing.particles.column(changing.column),
                        means, changed(means, masses), CarriedMap::exchange, {threads});
      const auto fractions = changing.particles.column(changing.column).values();
      return std::tuple{masses, means, std::vector<double>{fractions.begin(), fractions.end()}};
    };
    const auto alone = there_and_back(1);

    for (const int threads : {2, 3, 4}) EXPECT_EQ(there_and_back(threads), alone) << threads << " threads";
  });
}

/// Two points of equal mass in one cell, one all of class 0, the other without it; the cell loses class 0.
double fraction_after_losing_all(CarriedMap map) {
  const auto grid = cube<1>(1, 1.0, false);
  Particles<1> particles;
  particles.resize(2);
  const std::size_t column = particles.add_column({"size_fractions", "phi", "-"}, 2);
  Column& fractions = particles.column(column);
  for (Index p = 0; p < 2; ++p) {
    particles.mass.component(0)[p] = 1;
    particles.position.component(0)[p] = 0.25 + 0.5 * static_cast<double>(p);
    fractions.component(static_cast<int>(p))[p] = 1;
  }
  const auto blocks = cell_sort(particles, grid, 0, one_thread);
  CarriedCells<1, 1> carried{grid, Sites::cells, Linear{}};

  carried.to_points(blocks, particles, particles.column(column), std::vector{0.5, 0.5}, std::vector{0.0, 1.0},
                    map, one_thread);

  return std::min(particles.column(column).component(0)[0], particles.column(column).component(0)[1]);
}

TEST(ExchangeMap, KeepsAPointWithoutAClassAtZero) {  // Eq. (M22)
  EXPECT_EQ(fraction_after_losing_all(CarriedMap::exchange), 0);
}

TEST(IncrementMap, TakesFromAPointWhatItDoesNotHave) {  // Eq. (M23), the paper's eq. (11)
  EXPECT_EQ(fraction_after_losing_all(CarriedMap::increments), -0.5);
}

TEST(IncrementMap, LeavesTheBoundsByThePointsDistanceFromTheirMean) {  // Eq. (M23)
  Mixture<2> mixture;
  CarriedCells<2, 2> carried{mixture.grid, Sites::cells, Linear{}};
  const OnSites sites{mixture, carried};
  auto goal = sites.means;
  for (std::size_t at = 0; at < goal.size(); at += num_classes) {
    goal[at + 1] += goal[at];  // class 0 is to become class 1 everywhere
    goal[at] = 0;
  }
  double expected = 0;  // Phi_p - Phi_i of the point that has least, against the mean of its cell
  for (Index p = 0; p < mixture.particles.size(); ++p) {
    Index site = 0;
    for (int axis = 1; axis >= 0; --axis) {
      site = site * 4 + static_cast<Index>(std::floor(mixture.particles.position.component(axis)[p] / 0.1));
    }
    expected = std::min(expected,
                        mixture.fraction(p, 0) - sites.means[static_cast<std::size_t>(site) * num_classes]);
  }

  carried.to_points(mixture.blocks, mixture.particles, mixture.particles.column(mixture.column), sites.means,
                    goal, CarriedMap::increments, one_thread);

  EXPECT_LT(expected, -0.25);  // far out: the mean is about a third
  EXPECT_NEAR(mixture.bounds().smallest, expected, 10 * round_off);
}

/// Swaps random amounts of two classes between neighbouring sites: conserves all class masses.
void swap_between_neighbours(const std::vector<double>& masses, std::vector<double>& means,
                             std::mt19937& random) {
  std::uniform_real_distribution<double> draw{0, 0.5};
  for (std::size_t left = 0; left + 1 < masses.size(); ++left) {
    const std::size_t right = left + 1;
    const std::size_t up = random() % num_classes;
    const std::size_t down = (up + 1 + random() % (num_classes - 1)) % num_classes;
    double& left_loses = means[left * num_classes + up];
    double& right_loses = means[right * num_classes + down];
    const double amount = draw(random) * std::min(masses[left] * left_loses, masses[right] * right_loses);
    if (!(amount > 0)) continue;
    left_loses -= amount / masses[left];
    right_loses -= amount / masses[right];
    means[left * num_classes + down] += amount / masses[left];
    means[right * num_classes + up] += amount / masses[right];
  }
}

TEST(ExchangeMap, HoldsAllBoundsThroughTenThousandExchanges) {  // the acceptance of any coupled run
  Mixture<1> mixture{12, 40};
  on_all_sites(mixture.grid, [&](auto carried) {
    std::mt19937 random{23};
    std::array<double, num_classes> before{};
    for (std::size_t k = 0; k < num_classes; ++k) before[k] = mixture.class_mass(k);

    for (int n = 0; n < 10000; ++n) {
      const OnSites sites{mixture, carried};
      auto goal = sites.means;
      swap_between_neighbours(sites.masses, goal, random);
      carried.to_points(mixture.blocks, mixture.particles, mixture.particles.column(mixture.column),
                        sites.means, goal, CarriedMap::exchange, one_thread);
    }

    const auto bounds = mixture.bounds();
    EXPECT_GE(bounds.smallest, -1e-14);
    EXPECT_LE(bounds.largest, 1 + 1e-14);
    EXPECT_LE(bounds.sum_error, 1e-13);
    for (std::size_t k = 0; k < num_classes; ++k) {
      EXPECT_NEAR(mixture.class_mass(k) / before[k], 1, 1e-12);
    }
  });
}

TEST(CarriedCells, CountAPointOnTheLastWallToTheLastCell) {
  const auto grid = cube<1>(4, 0.25, false);
  Particles<1> particles;
  particles.resize(2);
  for (Index p = 0; p < 2; ++p) {
    particles.mass.component(0)[p] = 1;
    particles.position.component(0)[p] = static_cast<double>(p);  // on either wall
  }
  const auto blocks = cell_sort(particles, grid, 0, one_thread);
  const CarriedCells<1, 1> carried{grid, Sites::cells, Linear{}};
  std::vector<double> masses(4);

  carried.to_sites(particles, blocks, {}, masses, {}, one_thread);

  EXPECT_EQ(masses, (std::vector<double>{1, 0, 0, 1}));
}

TEST(CarriedCells, GiveANodeOnAWallHalfTheMassOfOthers) {  // images past the wall are folded back, Eq. (M21)
  constexpr Index per_cell = 64;
  const auto grid = cube<1>(6, 0.5, false);
  auto particles = filled<1>(grid, per_cell);
  const auto blocks = cell_sort(particles, grid, 0, one_thread);
  for (const AnyShape& shape : every<AnyShape>()) {
    const CarriedCells<1, 1> carried{grid, Sites::nodes, shape};
    std::vector<double> masses(7);

    carried.to_sites(particles, blocks, {}, masses, {}, one_thread);

    // Midpoint rule on pieces of parabolas with |N''| <= 2 over three cells: 2 x 3/(24 per_cell^2).
    const double tolerance = 6.0 / (24 * per_cell * per_cell);
    for (std::size_t node = 0; node < 7; ++node) {
      const double whole = 1000 * 0.5;  // [kg], one cell
      EXPECT_NEAR(masses[node] / whole, node == 0 || node == 6 ? 0.5 : 1, tolerance);
    }
  }
}

}  // namespace
}  // namespace scree::mpm
