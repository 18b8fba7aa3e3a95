#pragma once

#include <scree/transport/limiters.hpp>
#include <scree/transport/reconstructions/any_reconstruction.hpp>
#include <scree/transport/reconstructions/cweno3.hpp>
#include <scree/transport/reconstructions/piecewise_constant.hpp>
#include <scree/transport/reconstructions/piecewise_linear.hpp>
#include <scree/transport/reconstructions/piecewise_linear_common.hpp>
#include <scree/transport/type_list.hpp>

namespace scree::transport {

/// Every reconstruction there is, those with a limiter at minmod. A new one is its header and one entry.
using ReconstructionList = TypeList<  //
    PiecewiseConstant,                //
    PiecewiseLinear<Minmod>,          //
    PiecewiseLinearCommon<Minmod>,    //
    Cweno3>;

namespace detail {
template <class R, class List>
struct WithAnyOf;
template <template <Limiter> class R, Limiter L, class... Limiters>
struct WithAnyOf<R<L>, TypeList<Limiters...>> {
  using type = AnyReconstruction<R<Limiters>...>;
};
}  // namespace detail

/// A reconstruction with any limiter there is in the place of its own, chosen at run time.
template <class R>
using WithAnyLimiter = typename detail::WithAnyOf<R, LimiterList>::type;

}  // namespace scree::transport
