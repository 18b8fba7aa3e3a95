#include "instances.hpp"
#include "point_text.hpp"

#include <scree/mpm/law_inputs.hpp>

namespace scree::mpm {

template <int D, int V>
void require_in_range(const Particles<D, V>& particles, std::size_t column, const InputColumn& input,
                      std::string_view law) {
  const double* const values = particles.column(column).component(0);
  for (Index p = 0; p < particles.size(); ++p) {
    if (input.range.contains(values[p]) || particles.mass.component(0)[p] == 0) continue;
    scree::require_in_range(law, input, values[p], point_text(particles, p));
  }
}

#define SCREE_INSTANCE(D, V) \
  template void require_in_range(const Particles<D, V>&, std::size_t, const InputColumn&, std::string_view);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::mpm
