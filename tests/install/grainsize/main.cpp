// In a sheared column of two sizes, shear falling upwards, the coarse grains rise.
#include <scree/grainsize/distribution.hpp>
#include <scree/grainsize/segregation.hpp>
#include <scree/grid.hpp>

#include <vector>

int main() {
  namespace grainsize = scree::grainsize;
  using Vector = scree::Vector<1>;
  constexpr std::size_t num_cells = 50;
  const scree::CartesianGrid<1> column{Vector{0.0}, Vector{0.02}, {num_cells}, {false}};
  const auto mixture = grainsize::bidisperse(0.0005, 0.001, 0.5);
  grainsize::Segregation<1> segregation{
      mixture.classes, {.closure = grainsize::ShearRate{0.05}}, column.cells(), Vector{0.0}, {1}};
  const std::vector<double> masses(num_cells, 20.0);
  std::vector<double> drive;
  std::vector<double> fractions;
  for (std::size_t cell = 0; cell < num_cells; ++cell) {
    drive.push_back(4 * (1 - (static_cast<double>(cell) + 0.5) / num_cells));
    fractions.insert(fractions.end(), mixture.fractions.begin(), mixture.fractions.end());
  }

  segregation.advance(masses, drive, fractions, 10.0);

  const double fines_below = fractions.front();
  const double coarse_above = fractions.back();
  return fines_below > 0.99 && coarse_above > 0.99 ? 0 : 1;
}
