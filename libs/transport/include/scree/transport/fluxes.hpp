#pragma once

#include <scree/transport/fluxes/kurganov_noelle_petrova.hpp>
#include <scree/transport/fluxes/kurganov_tadmor.hpp>
#include <scree/transport/type_list.hpp>

namespace scree::transport {

/// Every numerical flux there is. A new one is its header and one entry here.
using FluxList = TypeList<  //
    KurganovTadmor,         //
    KurganovNoellePetrova>;

/// A numerical flux chosen at run time.
using AnyFlux = AnyOf<FluxList>;

}  // namespace scree::transport
