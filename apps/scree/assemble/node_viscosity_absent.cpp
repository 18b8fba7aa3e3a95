// In place of node_viscosity.cpp where rheology_stiff, and with it SUNDIALS, is not built.

#include "scree/assemble/node_viscosity.hpp"
#include "scree/scene/dimensions.hpp"

namespace scree::app {

template <int D, int V>
std::string choose_viscosity(const Scene& scene, const CartesianGrid<D>& /*grid*/,
                             mpm::Particles<D, V>& /*particles*/, mpm::Stages<D, V>& /*stages*/,
                             Threads /*threads*/) {
  require(scene.viscosity == ViscosityScheme::with_stress,
          "[numerics] viscosity is not \"explicit\", but this program was built without the library "
          "rheology_stiff");
  return {};
}

#define SCREE_INSTANCE(D, V)                                                                          \
  template std::string choose_viscosity(const Scene&, const CartesianGrid<D>&, mpm::Particles<D, V>&, \
                                        mpm::Stages<D, V>&, Threads);
SCREE_FOR_EACH_DIMENSION(SCREE_INSTANCE)
#undef SCREE_INSTANCE

}  // namespace scree::app
