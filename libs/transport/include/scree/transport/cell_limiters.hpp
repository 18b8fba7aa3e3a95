#pragma once

#include <scree/transport/cell_limiters/barth_jespersen.hpp>
#include <scree/transport/cell_limiters/smooth_cubic.hpp>
#include <scree/transport/cell_limiters/unlimited.hpp>
#include <scree/transport/cell_limiters/venkatakrishnan.hpp>
#include <scree/transport/type_list.hpp>

namespace scree::transport {

/// Every limiter of a cell's gradient. A new one is its header and one entry here.
using CellLimiterList = TypeList<  //
    SmoothCubic,                   //
    BarthJespersen,                //
    Venkatakrishnan,               //
    Unlimited>;

/// One chosen at run time.
using AnyCellLimiter = AnyOf<CellLimiterList>;

}  // namespace scree::transport
