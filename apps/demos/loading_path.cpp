// Soil in a triaxial cell: a point led along a path. It strengthens with the pressure round it, and dilates.
//
// Compression along y, the stresses along x and z held at sigma_3. Once the soil yields,
//
//   sigma_1 = N(phi) sigma_3 + 2 c sqrt(N(phi)),   dV/V = (N(psi) - 1) d eps_1,   N(a) = (1 + sin a)/(1 - sin
//   a)
//
// with cohesion c, friction angle phi and dilatancy angle psi, by the law of Mohr and Coulomb, Eq. (R51). The
// driver finds the strain along x and z that holds the stresses there, step by step; the law knows nothing of
// that.
#include "output.hpp"

#include <scree/rheology/laws/mohr_coulomb.hpp>
#include <scree/rheology/path/drive.hpp>
#include <scree/rheology/path/paths.hpp>

#include <array>
#include <cmath>
#include <cstdio>

using namespace scree;
using namespace scree::rheology;

namespace {

constexpr MohrCoulomb soil{.friction = 0.577,   // an angle of 30 degrees
                           .cohesion = 1e3,     // [Pa]
                           .dilatancy = 0.176,  // an angle of 10 degrees
                           .tension_strength = 0,
                           .shear_modulus = 5e5,  // [Pa]
                           .bulk_modulus = 1e6,   // [Pa]
                           .density = 1500};      // [kg/m^3]
constexpr Index num_steps = 300;
constexpr double compression = 0.03;  // in one second

/// (1 + sin a)/(1 - sin a) [-] of the tangent of an angle a.
double ratio_of(double tangent) {
  const double sine = tangent / std::sqrt(1 + tangent * tangent);
  return (1 + sine) / (1 - sine);
}

/// Presses the soil alike on all sides, then along y. Leaves the curves, counts what does not hold.
int compress(double pressure, std::vector<demo::Column>& curves) {
  const PathPointOf<MohrCoulomb> loose{soil, soil.density};
  PathPointOf<MohrCoulomb> point{soil, density_at_pressure(loose, pressure)};

  const auto records = drive(point, std::array{Stage{"shear", 1, num_steps, triaxial_drained(compression)}});

  demo::Column stress{"q_" + std::to_string(pressure), {}};
  demo::Column volume{"volume_" + std::to_string(pressure), {}};
  for (const PathRecord& record : records) {
    stress.values.push_back(record.deviatoric_stress);
    volume.values.push_back(record.volumetric_strain);
  }
  curves.push_back(stress);
  curves.push_back(volume);

  const PathRecord& end = records.back();
  const PathRecord& before = records[records.size() - 2];
  const double dilatancy =
      (end.volumetric_strain - before.volumetric_strain) / (before.at.strain(1, 1) - end.at.strain(1, 1));
  const double N = ratio_of(soil.friction);
  const double limit = (N - 1) * pressure + 2 * soil.cohesion * std::sqrt(N);
  const double expected = ratio_of(soil.dilatancy) - 1;
  std::printf("sigma_3 = %4.0f Pa  q = %10.4f Pa, exact %10.4f  dilatancy %.4f, of rigid soil %.4f\n",
              pressure, end.deviatoric_stress, limit, dilatancy, expected);
  // The driver holds stresses to 1e-10 of the largest, which q takes N-fold. Stresses per volume at rest grow
  // as the soil dilates, and elastic strains, p/K and q/(3 G), with them.
  const double elastic = end.pressure / soil.bulk_modulus + end.deviatoric_stress / (3 * soil.shear_modulus);
  const bool is_strength_right = std::abs(end.deviatoric_stress - limit) < 1e-8 * limit;
  const bool is_dilatancy_right = std::abs(dilatancy - expected) < elastic * expected;
  return (is_strength_right ? 0 : 1) + (is_dilatancy_right ? 0 : 1);
}

}  // namespace

int main(int argc, char** argv) {
  const auto folder = demo::folder_from(argc, argv);
  std::vector<demo::Column> curves{{"axial", {}}};
  for (Index n = 0; n <= num_steps; ++n) {
    curves.front().values.push_back(compression * static_cast<double>(n) / num_steps);
  }
  int faults = 0;
  for (const double pressure : {1e3, 2e3, 4e3}) faults += compress(pressure, curves);
  demo::write_table(folder / "loading_path.csv", curves);
  return faults;
}
