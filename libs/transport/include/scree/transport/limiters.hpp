#pragma once

#include <scree/transport/limiters/minmod.hpp>
#include <scree/transport/limiters/superbee.hpp>
#include <scree/transport/limiters/van_albada.hpp>
#include <scree/transport/limiters/van_leer.hpp>
#include <scree/transport/type_list.hpp>

namespace scree::transport {

/// Every limiter there is. A new one is its header and one entry here.
using LimiterList = TypeList<  //
    Minmod,                    //
    VanLeer,                   //
    Superbee,                  //
    VanAlbada>;

/// A limiter chosen at run time.
using AnyLimiter = AnyOf<LimiterList>;

}  // namespace scree::transport
