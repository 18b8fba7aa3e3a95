// A periodic box in steady simple shear, with disturbances along one direction on a mesh: where mu(I) is
// ill-posed they grow, and the faster the finer the mesh is; where it is well-posed, and with the regularised
// law, they die on every mesh.

#include "growth.hpp"

#include <scree/rheology/laws/mu_of_i.hpp>
#include <scree/rheology/laws/regularised_mu_of_i.hpp>

#include <gtest/gtest.h>

#include <vector>

namespace scree::rheology {
namespace {

/// Incompressible disturbances u(zeta) w of simple shear, w normal to the direction xi of zeta, in a box of
/// one metre that is periodic along xi. Velocities live in cells, stresses at faces; the pressure at a face
/// follows from momentum along xi, which keeps xi.sigma.xi as it was. The law is asked as it is, not
/// linearised.
template <class Law>
class ShearBox {
 public:
  ShearBox(const Law& law, double inertial_number, std::size_t num_cells)
      : law_{law},
        base_{simple_shear(rate_of(law, inertial_number, density_))},
        spacing_{1.0 / static_cast<double>(num_cells)},
        velocity_(num_cells) {
    const double angle = least_resisted_angle(law, inertial_number);
    xi_ = {std::cos(angle), std::sin(angle)};
    w_ = {-xi_[1], xi_[0]};
    const double viscosity = law.stiffness(Deformation<double>{base_, density_}, {1e-3}, {}).viscosity;
    // Of the shortest wave that the mesh has, whose second difference is -4/dx^2.
    rate_ =
        -resistance_along(law, inertial_number, angle) * viscosity * 4 / (law.density * spacing_ * spacing_);
    pressing_ = along(xi_, traction(0, density_));
  }

  /// Growth rate of the shortest wave, predicted from the law's own derivatives [1/s].
  [[nodiscard]] double predicted_rate() const { return rate_; }

  /// Up in one cell, down in the next: gradients of this share of the shear rate.
  void zigzag(double share) {
    for (std::size_t i = 0; i < velocity_.size(); ++i) {
      velocity_[i] = (i % 2 == 0 ? 0.5 : -0.5) * share * base_(0, 1) * spacing_;
    }
  }

  /// Noise, always the same, of a size that does not depend on the mesh: a share of the shear rate, over a
  /// metre.
  void noise(double share) {
    std::mt19937 random{11};
    std::uniform_real_distribution<double> any{-share * base_(0, 1), share * base_(0, 1)};
    for (double& u : velocity_) u = any(random);
  }

  /// Root mean square of the velocity [m/s].
  [[nodiscard]] double amplitude() const {
    double sum = 0;
    for (const double u : velocity_) sum += u * u;
    return std::sqrt(sum / static_cast<double>(velocity_.size()));
  }

  /// One explicit step [s].
  void step(double dt) {
    const std::size_t n = velocity_.size();
    std::vector<double> shear(n);  // at the face above each cell
    for (std::size_t i = 0; i < n; ++i) {
      shear[i] = along(w_, traction_at((velocity_[(i + 1) % n] - velocity_[i]) / spacing_));
    }
    for (std::size_t i = 0; i < n; ++i) {
      velocity_[i] += dt * (shear[i] - shear[(i + n - 1) % n]) / (law_.density * spacing_);
    }
  }

 private:
  using Pair = std::array<double, 2>;

  [[nodiscard]] static double along(const Pair& a, const Pair& b) { return a[0] * b[0] + a[1] * b[1]; }

  [[nodiscard]] Pair traction(double slope, double density) const {
    Tensor<double> gradient = base_;
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t j = 0; j < 2; ++j) gradient(i, j) += slope * w_[i] * xi_[j];
    }
    const auto sigma = stress(law_, gradient, density);
    return {sigma(0, 0) * xi_[0] + sigma(0, 1) * xi_[1], sigma(1, 0) * xi_[0] + sigma(1, 1) * xi_[1]};
  }

  /// Traction where u has this slope, at the density of the pressure that keeps xi.sigma.xi: Newton's method
  /// with the slope of the undisturbed state, whose error falls by the disturbance's share each time.
  [[nodiscard]] Pair traction_at(double slope) const {
    const double step = 1e-6 * density_;
    const double derivative = (along(xi_, traction(0, density_ + step)) - pressing_) / step;
    double density = density_;
    for (int n = 0; n < 4; ++n) density -= (along(xi_, traction(slope, density)) - pressing_) / derivative;
    return traction(slope, density);
  }

  Law law_;
  double density_ = 1.001 * law_.density;
  Tensor<double> base_;
  double spacing_;  // [m]
  std::vector<double> velocity_;
  Pair xi_{};
  Pair w_{};
  double rate_ = 0;
  double pressing_ = 0;  // xi.sigma.xi of the undisturbed state [Pa]
};

/// Growth of the shortest wave of a mesh over 60 steps of a tenth of its own time, per predicted growth. Its
/// gradients are between 1e-6 and 3e-4 of the shear rate, a factor of 1.1^60 or 0.9^60.
template <class Law>
[[nodiscard]] double growth_of_zigzag(const Law& law, double inertial_number, std::size_t num_cells) {
  ShearBox<Law> box{law, inertial_number, num_cells};
  box.zigzag(box.predicted_rate() > 0 ? 1e-6 : 3e-4);
  const double before = box.amplitude();
  const double dt = 0.1 / std::abs(box.predicted_rate());
  for (int n = 0; n < 60; ++n) box.step(dt);
  return std::log(box.amplitude() / before) / (60 * std::log1p(box.predicted_rate() * dt));
}

/// The curvature of the law, an odd function of the disturbance for up and down, changes its resistance by
/// the square of 3e-4, over a resistance of at least 0.02. The stress is rounded to 1e-16 of itself, K over p
/// = 1000 times that in the density, beside at least a millionth of it times the resistance: 5e-6 at worst.
constexpr double tolerance = 1e-5;

TEST(ShearBox, GrowsFasterOnEachFinerMeshWhereMuOfIIsIllPosed) {  // Eq. (R15)
  const auto beads = typical<MuOfI>();
  for (const double i : {0.005, 3.0}) {
    ASSERT_GT(stability_at(beads, i), 0);
    double coarser = 0;
    for (const std::size_t num_cells : {16U, 32U, 64U}) {
      const ShearBox<MuOfI> box{beads, i, num_cells};
      EXPECT_GT(box.predicted_rate(), 0) << i;
      if (coarser > 0) {
        EXPECT_NEAR(box.predicted_rate() / coarser, 4, 1e-12);  // as 1/dx^2
      }
      coarser = box.predicted_rate();

      EXPECT_NEAR(growth_of_zigzag(beads, i, num_cells), 1, tolerance) << i << ", " << num_cells << " cells";
    }
  }
}

/// Amplitude over that at the start, of the same noise after the same time.
template <class Law>
[[nodiscard]] double noise_left(const Law& law, double inertial_number, std::size_t num_cells, double share) {
  ShearBox<Law> box{law, inertial_number, num_cells};
  const double time = 1 / std::abs(ShearBox<Law>(law, inertial_number, 16).predicted_rate());
  box.noise(share);
  const double before = box.amplitude();
  const auto num_steps = static_cast<int>(std::ceil(10 * time * std::abs(box.predicted_rate())));
  for (int n = 0; n < num_steps; ++n) box.step(time / num_steps);
  return box.amplitude() / before;
}

/// In the time in which the shortest wave of 16 cells grows by e, that of 32 cells grows by e^4 and that of
/// 64 by e^16, steps of a tenth of its own time by 1.1^160 = e^15.2. In noise the shortest wave has a share
/// of some 1/sqrt(N). Well-posed, the same noise falls on each mesh.
TEST(ShearBox, IsAnotherAnswerOnEachMeshOnlyWhereMuOfIIsIllPosed) {
  const auto beads = typical<MuOfI>();
  EXPECT_GT(noise_left(beads, 0.005, 64, 1e-10), std::exp(9.0) * noise_left(beads, 0.005, 32, 1e-10));

  for (const double i : {0.05, 0.1, 0.3}) {
    for (const std::size_t num_cells : {16U, 32U, 64U}) {
      EXPECT_GT(least_resistance(beads, i), 0.02);
      EXPECT_LT(noise_left(beads, i, num_cells, 1e-6), 1) << i << ", " << num_cells << " cells";
      EXPECT_NEAR(growth_of_zigzag(beads, i, num_cells), 1, tolerance) << i << ", " << num_cells << " cells";
    }
  }
}

/// The remedy: with the same beads, at an inertial number where mu(I) is ill-posed.
TEST(ShearBox, IsCuredByTheRegularisedLaw) {  // Eqs. (R16), (R17)
  const auto cured = typical<RegularisedMuOfI>();
  auto ill = typical<MuOfI>();
  ill.mu_s = cured.mu_s;
  ill.mu_2 = cured.mu_2;
  ill.I_0 = cured.I_0;
  const double i = 0.002;
  ASSERT_GT(stability_at(ill, i), 0);

  for (const std::size_t num_cells : {16U, 32U, 64U}) {
    EXPECT_GT(ShearBox<MuOfI>(ill, i, num_cells).predicted_rate(), 0);
    EXPECT_LT(ShearBox<RegularisedMuOfI>(cured, i, num_cells).predicted_rate(), 0);
    EXPECT_LT(noise_left(cured, i, num_cells, 1e-6), 1) << num_cells << " cells";
  }
}

}  // namespace
}  // namespace scree::rheology
