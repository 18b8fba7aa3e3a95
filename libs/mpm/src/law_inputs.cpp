#include "instances.hpp"
#include "point_text.hpp"

#include <scree/error.hpp>
#include <scree/mpm/law_inputs.hpp>

#include <algorithm>
#include <string>

namespace scree::mpm {

template <int D, int V>
std::size_t input_column(const Particles<D, V>& particles, const InputColumn& input, std::string_view law) {
  const std::string reader = "the law '" + std::string{law} + "'";
  const std::size_t index = particles.find_column(input.name, reader);
  const std::string& unit = particles.column(index).quantity().unit;
  require(unit == input.unit, reader + " reads the column '" + std::string{input.name} + "' in " +
                                  std::string{input.unit} + ", but it is in " + unit);
  return index;
}

template <int D, int V>
std::size_t state_column(Particles<D, V>& particles, const StateColumn& state) {
  const std::string name{state.name};
  const std::size_t index = particles.add_column({name, name, std::string{state.unit}}, 1);
  std::ranges::fill(particles.column(index).values(), state.initial);
  return index;
}

template <int D, int V>
void require_in_range(const Particles<D, V>& particles, std::size_t column, const InputColumn& input,
                      std::string_view law) {
  const double* const values = particles.column(column).component(0);
  for (Index p = 0; p < particles.size(); ++p) {
    if (input.range.contains(values[p]) || particles.mass.component(0)[p] == 0) continue;
    scree::require_in_range(law, input, values[p], point_text(particles, p));
  }
}

#define SCREE_INSTANCE(D, V)                                                                       \
  template std::size_t input_column(const Particles<D, V>&, const InputColumn&, std::string_view); \
  template std::size_t state_column(Particles<D, V>&, const StateColumn&);                         \
  template void require_in_range(const Particles<D, V>&, std::size_t, const InputColumn&, std::string_view);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::mpm
