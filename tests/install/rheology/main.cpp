// A fluid of 750 Pa s bears 3 kPa of shear stress at 4 1/s.
#include <scree/rheology/laws.hpp>

int main() {
  const scree::rheology::Newtonian law{.viscosity = 750, .bulk_modulus = 1e7, .density = 1000};
  scree::rheology::validate(law);
  scree::Deformation<double> deformation{.velocity_gradient = {}, .density = 1000};
  deformation.velocity_gradient(0, 1) = 4;

  const auto response = law.update(deformation, {}, {}, 1e-3);

  return response.stress(0, 1) == 3000 ? 0 : 1;
}
