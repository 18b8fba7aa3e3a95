#pragma once

#include <scree/transport/laws/advection.hpp>
#include <scree/transport/laws/buckley_leverett.hpp>
#include <scree/transport/laws/buckley_leverett_gravity.hpp>
#include <scree/transport/laws/burgers.hpp>
#include <scree/transport/laws/capillary.hpp>
#include <scree/transport/laws/euler.hpp>
#include <scree/transport/laws/shallow_water.hpp>
#include <scree/transport/laws/user_law.hpp>
#include <scree/transport/type_list.hpp>

namespace scree::transport {

/// Every ready-made law there is, in one or two dimensions. A new one is its header and one entry here.
/// (A user's own is make_law(); grain-size classes are grainsize::SegregationLaw.)
template <int D>
using LawList = TypeList<        //
    Advection<D>,                //
    Burgers,                     //
    BuckleyLeverett,             //
    BuckleyLeverettGravity<D>,   //
    Capillary<BuckleyLeverett>,  //
    Euler<D>,                    //
    ShallowWater<D>>;

}  // namespace scree::transport
