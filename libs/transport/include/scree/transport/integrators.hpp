#pragma once

#include <scree/transport/time/forward_euler.hpp>
#include <scree/transport/time/ssp_rk2.hpp>
#include <scree/transport/time/ssp_rk3.hpp>
#include <scree/transport/type_list.hpp>

namespace scree::transport {

/// Every integrator there is. A new one is its header and one entry here.
using IntegratorList = TypeList<  //
    SspRk2,                       //
    SspRk3,                       //
    ForwardEuler>;

/// An integrator chosen at run time; SspRk2 unless another is given.
using AnyIntegrator = AnyOf<IntegratorList>;

}  // namespace scree::transport
