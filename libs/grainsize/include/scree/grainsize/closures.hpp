#pragma once

#include <scree/grainsize/closures/gravity.hpp>
#include <scree/grainsize/closures/shear_rate.hpp>
#include <scree/grainsize/closures/size_weighted_shear_rate.hpp>
#include <scree/transport/type_list.hpp>

namespace scree::grainsize {

/// Every segregation closure. A new one is its header and one entry here.
using ClosureList = transport::TypeList<  //
    ShearRate,                            //
    SizeWeightedShearRate,                //
    Gravity>;

/// A closure chosen at run time.
using AnyClosure = transport::AnyOf<ClosureList>;

}  // namespace scree::grainsize
