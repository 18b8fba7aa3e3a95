#include "bodies.hpp"

#include <gtest/gtest.h>

namespace scree::rheology {
namespace {

template <class Operator>
struct ViscousOperators : testing::Test {};
using AllDimensions = testing::Types<ViscousOperator<1, 1>, ViscousOperator<1, 2>, ViscousOperator<1, 3>,
                                     ViscousOperator<2, 2>, ViscousOperator<2, 3>, ViscousOperator<3, 3>>;
TYPED_TEST_SUITE(ViscousOperators, AllDimensions);

template <class Operator>
struct SizesOf;
template <int D_, int V_>
struct SizesOf<ViscousOperator<D_, V_>> {
  static constexpr int D = D_;
  static constexpr int V = V_;
};

/// Five by six by seven cells that differ in every direction.
template <int D>
CartesianGrid<D> uneven(bool is_periodic) {
  Vector<D> spacing;
  Indices<D> num_cells;
  std::array<bool, D> periodic;
  periodic.fill(is_periodic);
  for (int axis = 0; axis < D; ++axis) {
    spacing[axis] = 0.1 * (1 + axis);
    num_cells[test::at(axis)] = 5 + axis;
  }
  return {Vector<D>::Zero(), spacing, num_cells, periodic};
}

template <class Operator>
std::vector<double> pull(const Operator& viscous, const std::vector<double>& weights,
                         const std::vector<double>& v) {
  std::vector<double> out(v.size());
  viscous.apply({}, weights, v, out);
  return out;
}

TYPED_TEST(ViscousOperators, AreSymmetricAndNeverGainPower) {  // Eq. (R132)
  for (const bool is_periodic : {false, true}) {
    for (const Quadrature quadrature : {Quadrature::centre, Quadrature::gauss}) {
      const TypeParam viscous{uneven<SizesOf<TypeParam>::D>(is_periodic), quadrature};
      const auto weights = test::random_values(test::at(viscous.num_cells()), 0, 2);
      const auto both = test::random_values(2 * viscous.num_values(), -1, 1);
      const std::vector<double> u(both.begin(), both.begin() + static_cast<Index>(viscous.num_values()));
      const std::vector<double> v(both.begin() + static_cast<Index>(viscous.num_values()), both.end());
      const double scale = test::dot(pull(viscous, weights, u), u);
      EXPECT_GT(scale, 0);
      // Sums of num_values terms, each of 2^D cells' products.
      const double tolerance = static_cast<double>(viscous.num_values()) * 200 * round_off * scale;
      EXPECT_NEAR(test::dot(pull(viscous, weights, u), v), test::dot(pull(viscous, weights, v), u),
                  tolerance);
    }
  }
}

TYPED_TEST(ViscousOperators, SumToZeroForceWithoutWalls) {
  const TypeParam viscous{uneven<SizesOf<TypeParam>::D>(true)};
  const auto weights = test::random_values(test::at(viscous.num_cells()), 0, 2);
  const auto force = pull(viscous, weights, test::random_values(viscous.num_values(), -1, 1));
  for (int k = 0; k < SizesOf<TypeParam>::V; ++k) {
    double sum = 0;
    for (std::size_t i = test::at(k); i < force.size(); i += test::at(SizesOf<TypeParam>::V)) sum += force[i];
    EXPECT_NEAR(sum, 0, static_cast<double>(force.size()) * 24 * round_off * test::largest(force));
  }
}

TYPED_TEST(ViscousOperators, DoNotSeeRigidMotion) {
  constexpr int D = SizesOf<TypeParam>::D;
  constexpr int V = SizesOf<TypeParam>::V;
  const auto grid = uneven<D>(false);
  const TypeParam viscous{grid};
  const std::vector<double> weights(test::at(viscous.num_cells()), 1.0);
  const auto motion = test::values_at_nodes<V>(grid, [](const Vector<D>& x) {
    Vector<V> v;
    for (int k = 0; k < V; ++k) v[k] = 1 + k;
    if constexpr (D > 1) {
      v[0] -= 3 * x[1];
      v[1] += 3 * x[0];
    }
    return v;
  });
  // Of 2^D cells, 2^D V products each, of velocities up to 10 m/s.
  const double entry = viscous.cell().matrix.cwiseAbs().maxCoeff();
  EXPECT_LE(test::largest(pull(viscous, weights, motion)), 8 * 24 * round_off * 10 * entry);
}

TYPED_TEST(ViscousOperators, HaveTheShearRateOfALinearField) {  // Eq. (R131)
  constexpr int D = SizesOf<TypeParam>::D;
  constexpr int V = SizesOf<TypeParam>::V;
  Tensor<double> gradient;
  for (std::size_t i = 0; i < test::at(V); ++i) {
    for (std::size_t j = 0; j < test::at(D); ++j) {
      gradient(i, j) = 0.3 + 0.7 * static_cast<double>(i) - 0.4 * static_cast<double>(j * j);
    }
  }
  const auto grid = uneven<D>(false);
  const auto v = test::values_at_nodes<V>(grid, [&](const Vector<D>& x) {
    Vector<V> result = Vector<V>::Zero();
    for (int i = 0; i < V; ++i) {
      for (int j = 0; j < D; ++j) result[i] += gradient(test::at(i), test::at(j)) * x[j];
    }
    return result;
  });
  for (const Quadrature quadrature : {Quadrature::centre, Quadrature::gauss}) {
    const TypeParam viscous{grid, quadrature};
    std::vector<double> squares(test::at(viscous.num_cells()));
    viscous.products(v, v, squares);
    const double expected = std::pow(shear_rate(gradient), 2);
    // (2^D V)^2 products of velocities up to 2 m/s with entries of the matrix.
    const double tolerance = 576 * round_off * 4 * viscous.cell().matrix.cwiseAbs().maxCoeff();
    for (const double square : squares) EXPECT_NEAR(square, expected, tolerance);
  }
}

TYPED_TEST(ViscousOperators, HaveTheDiagonalOfTheirProducts) {
  const TypeParam viscous{uneven<SizesOf<TypeParam>::D>(true)};
  const auto weights = test::random_values(test::at(viscous.num_cells()), 0, 2);
  std::vector<double> diagonal(viscous.num_values());
  viscous.diagonal(weights, diagonal);
  for (std::size_t i = 0; i < diagonal.size(); i += 7) {
    std::vector<double> unit(diagonal.size(), 0.0);
    unit[i] = 1;
    EXPECT_NEAR(pull(viscous, weights, unit)[i], diagonal[i], 32 * round_off * diagonal[i]);
  }
}

TYPED_TEST(ViscousOperators, HaveTheSameBitsForAnyNumberOfThreads) {
  const auto grid = uneven<SizesOf<TypeParam>::D>(true);
  const TypeParam one{grid, Quadrature::gauss, Threads{1}};
  const TypeParam four{grid, Quadrature::gauss, Threads{4}};
  const auto weights = test::random_values(test::at(one.num_cells()), 0, 2);
  const auto v = test::random_values(one.num_values(), -1, 1);
  EXPECT_EQ(pull(one, weights, v), pull(four, weights, v));
}

/// |amplification| of the shortest wave along x, of one component, by explicit Euler.
template <int D, int V>
double amplification(int component, double dt, Quadrature quadrature, bool along_all = false) {
  const auto grid = test::cube<D>(8, true);
  const ViscousOperator<D, V> viscous{grid, quadrature};
  const auto mass = test::full(grid, 1);
  const std::vector<double> weights(test::at(viscous.num_cells()), grid.spacing().prod());
  const auto v = test::values_at_nodes<V>(grid, [&](const Vector<D>& x) {
    Vector<V> wave = Vector<V>::Zero();
    const double phase = along_all ? x.sum() : x[0];
    wave[component] = std::cos(test::pi * 8 * phase);
    return wave;
  });
  const auto k = pull(viscous, weights, v);
  return std::abs(1 - dt * k[test::at(component)] / (mass[0] * v[test::at(component)]));
}

TEST(ViscousOperator, ExplicitStepsBlowUpAboveTheViscousLimitAndNotBelow) {  // Eq. (R133)
  const double shear_limit = 1.0 / (8 * 8) / 2;                              // rho dx^2/(2 mu)
  const auto expect_limit = [](double limit, auto&& wave) {
    EXPECT_NEAR(wave(0.99 * limit), 0.98, 1e-12);  // |1 - 2 share|
    EXPECT_NEAR(wave(1.01 * limit), 1.02, 1e-12);
  };
  for (const Quadrature q : {Quadrature::centre, Quadrature::gauss}) {
    expect_limit(shear_limit, [&](double dt) { return amplification<1, 2>(1, dt, q); });
    expect_limit(shear_limit, [&](double dt) { return amplification<2, 2>(1, dt, q); });
    expect_limit(shear_limit, [&](double dt) { return amplification<3, 3>(2, dt, q); });
    // Compression feels 4/3 of the viscosity.
    expect_limit(0.75 * shear_limit, [&](double dt) { return amplification<1, 1>(0, dt, q); });
    expect_limit(0.75 * shear_limit, [&](double dt) { return amplification<2, 2>(0, dt, q); });
    expect_limit(0.75 * shear_limit, [&](double dt) { return amplification<3, 3>(0, dt, q); });
  }
}

TYPED_TEST(ViscousOperators, KnowTheirLargestRate) {  // Eq. (R135)
  constexpr int D = SizesOf<TypeParam>::D;
  const auto grid = test::cube<D>(8, true);
  const TypeParam viscous{grid};
  const std::vector<double> weights(test::at(viscous.num_cells()), grid.spacing().prod());
  // In one dimension that of compression, 4/3 of 4 mu/(rho dx^2). In more, one cell alone can be squeezed at
  // constant volume, 2 of that, which no wave does to all cells.
  const double rate = (D == 1 ? 4.0 / 3 : 2) * 4 * 8 * 8;
  EXPECT_NEAR(viscous.largest_rate(test::full(grid, 1), weights), rate, 1e-12 * rate);
}

TYPED_TEST(ViscousOperators, NeverExceedTheirLargestRate) {
  const TypeParam viscous{uneven<SizesOf<TypeParam>::D>(false)};
  const auto weights = test::random_values(test::at(viscous.num_cells()), 0, 2);
  const auto mass = test::random_values(test::at(viscous.num_nodes()), 0.1, 2);
  const double bound = viscous.largest_rate(mass, weights);
  auto v = test::random_values(viscous.num_values(), -1, 1);
  double rate = 0;
  for (int n = 0; n < 100; ++n) {  // the power method finds rates from below
    auto k = pull(viscous, weights, v);
    for (std::size_t i = 0; i < k.size(); ++i) k[i] /= mass[i / test::at(SizesOf<TypeParam>::V)];
    rate = test::largest(k) / test::largest(v);
    for (std::size_t i = 0; i < k.size(); ++i) v[i] = k[i] / test::largest(k);
  }
  EXPECT_LE(rate, bound * (1 + 1e-12));
  EXPECT_GE(rate, bound / 4);  // not a useless bound either
}

TEST(ViscousOperator, SeesAlternatingVelocitiesFromGaussPointsOnly) {  // where `centre` fails, and the remedy
  EXPECT_NEAR((amplification<2, 2>(0, 1, Quadrature::centre, true)), 1, 1e-12);
  // Each axis' share of the rate falls to a third: 4/3 + 1 thirds of 4/dx^2.
  const double rate = (4.0 / 3 + 1) / 3 * 4 * 64;
  EXPECT_NEAR((amplification<2, 2>(0, 1, Quadrature::gauss, true)), rate - 1, 1e-12 * rate);
}

TEST(ViscousOperator, HasTheDerivativeOfItsForce) {  // Eq. (R134)
  const auto grid = test::cube<2>(5, false);
  const ViscousOperator<2> viscous{grid};
  const std::size_t num_cells = test::at(viscous.num_cells());
  const auto u = test::random_values(viscous.num_values(), -1, 1);
  auto v = test::random_values(viscous.num_values() + 3, -1, 1);
  v.erase(v.begin(), v.begin() + 3);
  const auto force = [&](double s) {  // with the viscosity 1/gdot^(1/2)
    std::vector<double> w = u;
    for (std::size_t i = 0; i < w.size(); ++i) w[i] += s * v[i];
    std::vector<double> weights(num_cells);
    viscous.products(w, w, weights);
    for (double& weight : weights) weight = std::pow(weight, -0.25);
    return pull(viscous, weights, w);
  };
  std::vector<double> weights(num_cells);
  std::vector<double> couplings(num_cells);
  std::vector<double> product(viscous.num_values());
  std::vector<double> along(num_cells);
  viscous.products(u, u, weights);
  viscous.products(u, v, along);
  for (std::size_t c = 0; c < num_cells; ++c) {
    const double rate = std::sqrt(weights[c]);
    weights[c] = 1 / std::sqrt(rate);
    couplings[c] = -0.5 * std::pow(rate, -1.5) / rate * along[c];  // mu'/gdot u.Kv
  }
  viscous.apply_tangent({}, weights, couplings, u, v, product);
  constexpr double step = 1e-5;
  const auto ahead = force(step);
  const auto behind = force(-step);
  for (std::size_t i = 0; i < product.size(); ++i) {
    // step^2 times a third derivative, some (1/gdot)^2 of the force, and round-off over the step.
    EXPECT_NEAR((ahead[i] - behind[i]) / (2 * step), product[i], 1e-8 * test::largest(product)) << i;
  }
}

}  // namespace
}  // namespace scree::rheology
