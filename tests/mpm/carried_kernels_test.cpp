#include "bodies.hpp"
#include "messages.hpp"
#include "schemes.hpp"

#include <scree/mpm/carried_cells.hpp>
#include <scree/mpm/cell_sort.hpp>
#include <scree/mpm/exchange_map.hpp>
#include <scree/mpm/shapes/top_hat.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace scree::mpm {
namespace {

constexpr Threads one_thread{1};
template <int D>
constexpr Index num_cells = block_edge<D> + 5;  // along each axis: more than one block and its skin
constexpr double spacing = 0.1;                 // [m]

/// Points in any place of the mesh that have moved since they were sorted, as far as they may.
template <int D>
struct Cloud {
  Cloud(bool is_periodic, int num_classes, double shift) : grid{cube<D>(num_cells<D>, spacing, is_periodic)} {
    particles = scattered<D>(grid, 300, 0);
    column = particles.add_column({"size_fractions", "phi", "-"}, num_classes);
    std::mt19937 random{29};
    std::uniform_real_distribution<double> draw{0, 1};
    for (Index p = 0; p < particles.size(); ++p) {
      double sum = 0;
      for (int k = 0; k < num_classes; ++k) sum += fractions().component(k)[p] = draw(random);
      for (int k = 0; k < num_classes; ++k) fractions().component(k)[p] /= sum;
    }
    blocks = cell_sort(particles, grid, shift, one_thread);
    for (double& x : particles.position.values()) {
      const double moved = x + (2 * draw(random) - 1) * block_skin<D> * 0.999 * spacing;
      x = is_periodic ? moved : std::clamp(moved, 0.0, num_cells<D> * spacing);
    }
  }
  [[nodiscard]] Column& fractions() { return particles.column(column); }

  CartesianGrid<D> grid;
  Particles<D> particles;
  std::size_t column = 0;
  ParticleBlocks<D> blocks;
};

/// What kernels are compared with: the equations on single numbers, site after site.
template <class ShapeType, int D>
class ReferenceCarried {
 public:
  explicit ReferenceCarried(const Lattice<D>& lattice) : lattice_{lattice} {}

  /// Calls body(site, weight) for each site of a point.
  template <class Body>
  void for_each_site(const Particles<D>& particles, Index p, Body&& body) const {
    constexpr std::size_t S = ShapeType::support;
    std::size_t count = 1;
    for (int axis = 0; axis < D; ++axis) count *= S;
    for (std::size_t n = 0; n < count; ++n) {
      Indices<D> site{};
      double weight = 1;
      std::size_t rest = n;
      for (std::size_t axis = 0; axis < D; ++axis, rest /= S) {
        const double x = particles.position.component(static_cast<int>(axis))[p] / spacing;
        const double base = std::floor(x - ShapeType::shift);
        weight *= ShapeType{}.weights(x - base)[rest % S];
        site[axis] = along(static_cast<Index>(base) + static_cast<Index>(rest % S), axis);
      }
      if (weight != 0) body(static_cast<std::size_t>(lattice_.index(site)), weight);
    }
  }

  /// The number of a site along an axis, or of what it is the image of.
  [[nodiscard]] Index along(Index site, std::size_t axis) const {
    const Index n = lattice_.count[axis];
    if (lattice_.is_periodic[axis]) return (site % n + n) % n;
    if (lattice_.sites == Sites::cells) return std::min(site, n - 1);
    return site < 0 ? -site : site >= n ? 2 * (n - 1) - site : site;
  }

  /// Sums of mass and of mass times each class.
  [[nodiscard]] std::vector<double> sums(const Particles<D>& particles, const Column& fractions) const {
    const auto size = static_cast<std::size_t>(fractions.num_components()) + 1;
    std::vector<double> result(static_cast<std::size_t>(lattice_.num_sites()) * size);
    for (Index p = 0; p < particles.size(); ++p) {
      for_each_site(particles, p, [&](std::size_t site, double weight) {
        const double share = weight * particles.mass.component(0)[p];
        result[site * size] += share;
        for (std::size_t k = 1; k < size; ++k) {
          result[site * size + k] += share * fractions.component(static_cast<int>(k) - 1)[p];
        }
      });
    }
    return result;
  }

  /// The fractions of a point after an exchange, Eq. (M22), or increments, Eq. (M23).
  [[nodiscard]] std::vector<double> changed(const Particles<D>& particles, const Column& fractions, Index p,
                                            const std::vector<double>& before,
                                            const std::vector<double>& after, CarriedMap map) const {
    const auto num_classes = static_cast<std::size_t>(fractions.num_components());
    const auto phi = [&](std::size_t k) { return fractions.component(static_cast<int>(k))[p]; };
    std::vector<double> result(num_classes);
    for (std::size_t k = 0; k < num_classes; ++k) result[k] = phi(k);
    std::vector<double> loss(num_classes);
    std::vector<double> gain(num_classes);
    for_each_site(particles, p, [&](std::size_t site, double weight) {
      const std::span<const double> old_means{before.data() + site * num_classes, num_classes};
      const std::span<const double> new_means{after.data() + site * num_classes, num_classes};
      exchange_at_site(old_means, new_means, loss, gain);
      double given = 0;
      for (std::size_t k = 0; k < num_classes; ++k) given += phi(k) * loss[k];
      for (std::size_t k = 0; k < num_classes; ++k) {
        result[k] += map == CarriedMap::exchange ? weight * (gain[k] * given - phi(k) * loss[k])
                                                 : weight * (new_means[k] - old_means[k]);
      }
    });
    return result;
  }

 private:
  Lattice<D> lattice_;
};

/// How far two ways of rounding can be apart for a weight of a point: a coordinate of up to num_cells<D> and
/// the skin is rounded three times, and no weight changes by more than one per spacing; it takes ten
/// roundings itself. A product has D of them, each way.
template <int D>
constexpr double apart = 2 * round_off* D*(3.0 * (num_cells<D> + block_skin<D>)+10);

template <class S, int D>
void expect_sums_of_single_numbers(Sites sites, const AnyShape& shape, InstructionSet set, bool is_periodic,
                                   int num_classes) {
  Cloud<D> cloud{is_periodic, num_classes, std::visit([](const auto& one) { return one.shift; }, shape)};
  const CarriedCells<D, D> carried{cloud.grid, sites, shape, set};
  std::vector<CarriedField> fields;
  fields.reserve(static_cast<std::size_t>(num_classes));
  for (int k = 0; k < num_classes; ++k) fields.push_back({&cloud.fractions(), k});
  std::vector<double> masses(static_cast<std::size_t>(carried.lattice().num_sites()));
  std::vector<double> means(masses.size() * fields.size());

  carried.to_sites(cloud.particles, cloud.blocks, fields, masses, means, one_thread);

  const ReferenceCarried<S, D> reference{carried.lattice()};
  const auto expected = reference.sums(cloud.particles, cloud.fractions());
  double mass = 0;
  for (const double m : cloud.particles.mass.values()) mass += m;
  const double terms = static_cast<double>(cloud.particles.size());
  const double tolerance = (apart<D> + 2 * 5 * terms * round_off) * mass;  // five roundings of each term
  for (std::size_t site = 0; site < masses.size(); ++site) {
    const double* sum = expected.data() + site * (fields.size() + 1);
    EXPECT_NEAR(masses[site], sum[0], tolerance);
    for (std::size_t k = 0; k < fields.size(); ++k) {
      EXPECT_NEAR(means[site * fields.size() + k] * masses[site], sum[1 + k], tolerance);
    }
  }
}

template <class S, int D>
void expect_changes_of_single_numbers(Sites sites, const AnyShape& shape, InstructionSet set,
                                      bool is_periodic, int num_classes, CarriedMap map) {
  Cloud<D> cloud{is_periodic, num_classes, std::visit([](const auto& one) { return one.shift; }, shape)};
  CarriedCells<D, D> carried{cloud.grid, sites, shape, set};
  const auto num_sites = static_cast<std::size_t>(carried.lattice().num_sites());
  const auto K = static_cast<std::size_t>(num_classes);
  std::mt19937 random{31};
  std::uniform_real_distribution<double> draw{0, 1};
  const auto means_at_random = [&] {
    std::vector<double> means(num_sites * K);
    for (std::size_t site = 0; site < num_sites; ++site) {
      double sum = 0;
      for (std::size_t k = 0; k < K; ++k) sum += means[site * K + k] = draw(random);
      for (std::size_t k = 0; k < K; ++k) means[site * K + k] /= sum;
    }
    return means;
  };
  const auto before = means_at_random();
  const auto after = means_at_random();
  const Column old = cloud.fractions();

  carried.to_points(cloud.blocks, cloud.particles, cloud.fractions(), before, after, map, one_thread);

  const ReferenceCarried<S, D> reference{carried.lattice()};
  const double stencil = std::pow(static_cast<double>(S::support), D);
  // Each site gives and takes at most what a point has, which K terms make; then the last digit of the sum.
  const double tolerance = 2 * stencil * apart<D> + 2 * (2 * stencil + 4 * num_classes) * round_off;
  for (Index p = 0; p < cloud.particles.size(); ++p) {
    const auto expected = reference.changed(cloud.particles, old, p, before, after, map);
    for (std::size_t k = 0; k < K; ++k) {
      EXPECT_NEAR(cloud.fractions().component(static_cast<int>(k))[p], expected[k], tolerance);
    }
  }
}

/// Calls test.template operator()<ShapeType>(sites, shape, set, is periodic, classes) for all there are.
template <class Test>
void for_every_kernel(Test&& test) {
  for (const InstructionSet set : instruction_sets()) {
    for (const bool is_periodic : {false, true}) {
      for (const int num_classes : {1, 3, 6, 13}) {
        SCOPED_TRACE(std::string{name_of(set)} + (is_periodic ? ", periodic, " : ", ") +
                     std::to_string(num_classes) + " classes");
        for (const AnyShape& shape : every<AnyShape>()) {
          test(TopHat{}, Sites::cells, shape, set, is_periodic, num_classes);
          std::visit([&](const auto& one) { test(one, Sites::nodes, shape, set, is_periodic, num_classes); },
                     shape);
        }
      }
    }
  }
}

template <class Dimension>
class CarriedKernels : public ::testing::Test {};
TYPED_TEST_SUITE(CarriedKernels, Dimensions);

TYPED_TEST(CarriedKernels, GiveTheSitesWhatSingleNumbersGive) {  // Eq. (M21)
  for_every_kernel([](const auto& one, auto... what) {
    expect_sums_of_single_numbers<std::decay_t<decltype(one)>, TypeParam::value>(what...);
  });
}

TYPED_TEST(CarriedKernels, ExchangeOnThePointsWhatSingleNumbersExchange) {  // Eq. (M22)
  for_every_kernel([](const auto& one, auto... what) {
    expect_changes_of_single_numbers<std::decay_t<decltype(one)>, TypeParam::value>(what...,
                                                                                    CarriedMap::exchange);
  });
}

TYPED_TEST(CarriedKernels, AddToThePointsWhatSingleNumbersAdd) {  // Eq. (M23)
  for_every_kernel([](const auto& one, auto... what) {
    expect_changes_of_single_numbers<std::decay_t<decltype(one)>, TypeParam::value>(what...,
                                                                                    CarriedMap::increments);
  });
}

TEST(CarriedCells, RefuseAnInstructionSetThatIsNotThere) {
  const auto sets = instruction_sets();
  const auto grid = cube<1>(4, spacing, false);
  for (const auto set : {InstructionSet::x86_64_v3, InstructionSet::x86_64_v4}) {
    if (std::ranges::find(sets, set) != sets.end()) continue;
    EXPECT_EQ(message_of<InputError>([&] {
                const CarriedCells<1, 1> carried{grid, Sites::cells, Linear{}, set};
              }),
              "CarriedCells: there are no kernels for " + std::string{name_of(set)} +
                  " in this build or on this machine");
  }
}

}  // namespace
}  // namespace scree::mpm
