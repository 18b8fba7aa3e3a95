#include "scree/assemble/crushing.hpp"

#include "scree/scene/dimensions.hpp"
#include "scree/scene/law_columns.hpp"
#include "scree/scene/material_columns.hpp"

#include <scree/grainsize/breakage.hpp>

namespace scree::app {

namespace {

/// The breakage that the fractions of a point have followed.
constexpr std::string_view crushed_column = "crushed";

}  // namespace

template <int D, int V>
Crushing<D, V>::Crushing(mpm::Particles<D, V>& particles, const grainsize::Distribution& grains,
                         double fractal_dimension)
    : ultimate_{grainsize::ultimate_fractions(grains.classes, grains.fractions, fractal_dimension)} {
  particles.add_column({std::string{crushed_column}, "B", "-"}, 1);
}

template <int D, int V>
bool Crushing<D, V>::advance(mpm::Particles<D, V>& particles) const {
  const auto number = [&](std::string_view name) {
    return particles.column(particles.find_column(name, "crushing")).component(0);
  };
  const double* breakage = number(breakage_column);
  double* crushed = number(crushed_column);
  mpm::Column& fractions = particles.column(particles.find_column(fraction_column, "crushing"));
  bool is_any_finer = false;
  for (Index p = 0; p < particles.size(); ++p) {
    const double share = grainsize::broken_share(crushed[p], breakage[p]);
    if (share == 0) continue;
    is_any_finer = true;
    crushed[p] = breakage[p];
    for (int k = 0; k < fractions.num_components(); ++k) {
      double& phi = fractions.component(k)[p];
      phi = grainsize::broken_fraction(phi, ultimate_[static_cast<std::size_t>(k)], share);
    }
  }
  return is_any_finer;
}

#define SCREE_INSTANCE(D, V) template class Crushing<D, V>;
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::app
