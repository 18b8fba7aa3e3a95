// The same bits for any number of threads, whatever surrounds the material.

#include "bodies.hpp"
#include "dry_wall.hpp"
#include "same_bits.hpp"

#include <scree/mpm/axisymmetric.hpp>
#include <scree/mpm/boundaries/bed.hpp>
#include <scree/mpm/boundaries/frictional.hpp>
#include <scree/mpm/boundaries/rigid_body.hpp>
#include <scree/mpm/node_means.hpp>

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace scree::mpm {
namespace {

constexpr Fluid mud{.bulk_modulus = 1e4, .reference_density = 1000, .viscosity = 2};

/// What acts on stirred mud besides itself.
template <int D>
struct Surroundings {
  std::string name;
  AnyShape shape;
  AnyTransfer rule;
  std::function<void(Stages<D, D>&, Particles<D>&, const CartesianGrid<D>&)> put;
};

template <int D>
void put_walls(Stages<D, D>& stages, const AnyWall& low, const AnyWall& high) {
  for (int axis = 0; axis < D; ++axis) {
    stages.boundaries.push_back(make_wall<D>(low, axis, Side::low));
    stages.boundaries.push_back(make_wall<D>(high, axis, Side::high));
  }
}

template <int D>
void put_rubbing_walls(Stages<D, D>& stages) {
  for (int axis = 0; axis < D; ++axis) {
    for (const Side side : {Side::low, Side::high}) {
      stages.boundaries.push_back(make_frictional_wall<D>(Dry{}, {}, Hold::pushes, axis, side));
    }
  }
}

/// A plane that cuts the mesh obliquely.
template <int D>
[[nodiscard]] AnySurface<D> slope() {
  Vector<D> normal = Vector<D>::Constant(0.2);
  normal[1] = 1;
  return PlaneSurface<D>{Vector<D>::Constant(0.5), normal.normalized()};
}

/// A ball in the middle that turns as it goes through the mesh.
template <int D>
[[nodiscard]] std::unique_ptr<Boundary<D>> ball(const CartesianGrid<D>& grid) {
  const Vector<D> middle = Vector<D>::Constant(grid.length(0) / 2);
  return make_rigid_body<D>(
      Contact<Dry>{}, AnySurface<D>{BallSurface<D>{middle, 0.4, BallSurface<D>::Material::outside}},
      RigidMotion<D>{.pivot = middle,
                     .place = [middle](double t) -> Vector<D> { return middle + t * Vector<D>::Unit(0); },
                     .angle = [](double t) { return 3 * t; }});
}

/// A bed whose friction is what points carry to its nodes.
template <int D>
void put_bed_that_reads(Stages<D, D>& stages, Particles<D>& particles, const CartesianGrid<D>& grid,
                        const AnyShape& shape) {
  const std::size_t column = particles.add_column({"friction", "mu", "-"}, 1);
  fill_at_random(particles.column(column), 0.5);
  for (double& mu : particles.column(column).values()) mu += 0.5;
  stages.node_means = std::make_unique<NodeMeans<D, D>>(shape);
  CarriedInput<Rubs> carried;
  carried.read(0, stages.node_means->add(particles, "friction", Rubs::inputs[0], Rubs::name));
  stages.boundaries.push_back(make_bed<D, Rubs>(
      Contact<Rubs>{}, [](const Vector<D>&) { return Rubs::Input<double>{}; }, grid, slope<D>(),
      Symmetry::plane, carried));
}

template <int D>
[[nodiscard]] std::vector<Surroundings<D>> every_surroundings() {
  using Grid = const CartesianGrid<D>&;
  return {
      {"two mirror walls on each axis", Quadratic{}, Apic{},
       [](auto& stages, auto&, Grid) { put_walls<D>(stages, Slip{}, Slip{}); }},
      {"mirror walls of two kinds", Cubic{}, PicFlip{1},
       [](auto& stages, auto&, Grid) { put_walls<D>(stages, NoSlip{}, Slip{}); }},
      {"walls that rub", Quadratic{}, Aflip{},
       [](auto& stages, auto&, Grid) { put_rubbing_walls<D>(stages); }},
      {"walls that rub, gradients mended", Cubic{}, Apic{},  // Eq. (M197)
       [](auto& stages, auto&, Grid) { put_rubbing_walls<D>(stages); }},
      {"a bed", Quadratic{}, Apic{},
       [](auto& stages, auto&, Grid grid) {
         stages.boundaries.push_back(make_bed<D>(Contact<Dry>{}, grid, slope<D>()));
       }},
      {"a bed that reads points", Quadratic{}, Apic{},
       [](auto& stages, auto& particles, Grid grid) {
         put_bed_that_reads<D>(stages, particles, grid, Quadratic{});
       }},
      {"a body that moves and turns", Linear{}, Tpic{},
       [](auto& stages, auto&, Grid grid) { stages.boundaries.push_back(ball<D>(grid)); }},
      {"a bed, a body and walls", Cubic{}, Apic{},
       [](auto& stages, auto&, Grid grid) {
         put_rubbing_walls<D>(stages);
         stages.boundaries.push_back(make_bed<D>(Contact<Dry>{}, grid, slope<D>()));
         stages.boundaries.push_back(ball<D>(grid));
       }},
      {"ends that throw points back", Quadratic{}, Apic{},
       [](auto& stages, auto& particles, Grid) {
         stages.leaving = Leaving::reflect;
         fill_at_random(particles.velocity, 40.0);  // a fifth of a cell a step
       }},
      {"ends that absorb", Linear{}, PicFlip{1},
       [](auto& stages, auto& particles, Grid) {
         stages.leaving = Leaving::absorb;
         fill_at_random(particles.velocity, 40.0);
       }},
  };
}

/// Points in several blocks of each colour, some of which pass the ends if those let them.
template <int D>
[[nodiscard]] State<D, D> stirred(const Surroundings<D>& surroundings, Threads threads) {
  const auto grid = cube<D>(D == 2 ? 64 : 20, 0.1, false);
  auto particles = scattered<D>(grid, 2000, 0.02);
  fill_at_random(particles.velocity, 1.0);
  auto stages = stages_of<D, D>(particles, surroundings.shape, surroundings.rule, mud);
  stages.gravity[1] = -9.81;
  surroundings.put(stages, particles, grid);
  auto state = start(std::move(particles), grid, stages, threads);
  for (int n = 0; n < 3; ++n) step(state, stages, 5e-4, threads);
  return state;
}

template <int D>
void expect_same_bits_for_any_number_of_threads(const Surroundings<D>& surroundings) {
  const auto one = stirred(surroundings, {1});
  EXPECT_EQ(one.absorbed.count > 0, surroundings.name == "ends that absorb");
  for (const int threads : {2, 3, 4}) {
    SCOPED_TRACE(surroundings.name + ", " + std::to_string(threads) + " threads");

    const auto several = stirred(surroundings, {threads});

    expect_same_bits(one.particles, several.particles);
    EXPECT_EQ(one.rates.advection_rate, several.rates.advection_rate);
    EXPECT_EQ(one.absorbed.mass, several.absorbed.mass);
    EXPECT_EQ(one.absorbed.momentum, several.absorbed.momentum);
  }
}

TEST(EverySurroundings, GiveTheSameBitsForAnyNumberOfThreads) {
  for (const auto& one : every_surroundings<2>()) expect_same_bits_for_any_number_of_threads(one);
  for (const auto& one : every_surroundings<3>()) expect_same_bits_for_any_number_of_threads(one);
}

TEST(Axisymmetric, GivesTheSameBitsForAnyNumberOfThreads) {
  for (const AnyShape& shape : {AnyShape{Linear{}}, AnyShape{Quadratic{}}, AnyShape{Cubic{}}}) {
    const auto round_an_axis = [&](auto& stages, auto& particles, const CartesianGrid<2>& grid) {
      stages.point_term = make_axisymmetric(particles, grid, shape);
      stages.boundaries.push_back(make_wall<2>(Slip{}, 0, Side::low));
      stages.boundaries.push_back(
          make_frictional_wall<2>(Dry{}, {}, Hold::pushes, 1, Side::low, Symmetry::axial));
    };
    expect_same_bits_for_any_number_of_threads<2>({"round an axis", shape, Apic{}, round_an_axis});
  }
}

}  // namespace
}  // namespace scree::mpm
