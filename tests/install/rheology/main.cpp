// A fluid of 750 Pa s bears 3 kPa of shear stress at 4 1/s: at one point, and at thirteen.
#include <scree/rheology/batch.hpp>
#include <scree/rheology/laws.hpp>

#include <algorithm>
#include <array>
#include <vector>

namespace rheology = scree::rheology;

namespace {

constexpr rheology::Newtonian law{.viscosity = 750, .bulk_modulus = 1e7, .density = 1000};

double stress_of_a_point() {
  scree::Deformation<double> deformation{.velocity_gradient = {}, .density = 1000};
  deformation.velocity_gradient(0, 1) = 4;
  return law.update(deformation, {}, {}, 1e-3).stress(0, 1);
}

std::vector<double> stresses_of_a_batch() {
  const std::vector<double> zeros(13);
  const std::vector<double> shear_rate(13, 4.0);
  const std::vector<double> density(13, 1000.0);
  std::array<std::vector<double>, 6> stress;
  stress.fill(zeros);

  rheology::LawColumns<rheology::Newtonian> columns{.density = density};
  columns.velocity_gradient.fill(zeros);  // columns that are only read may be shared
  columns.velocity_gradient[1] = shear_rate;
  std::ranges::copy(stress, columns.stress.begin());
  rheology::validate_columns(columns);
  rheology::update_batch(law, columns, 1e-3);
  return stress[3];  // xy
}

}  // namespace

int main() {
  rheology::validate(law);
  const bool is_right =
      stress_of_a_point() == 3000 && stresses_of_a_batch() == std::vector<double>(13, 3000.0);
  return is_right ? 0 : 1;
}
