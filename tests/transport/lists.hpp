#pragma once

#include <scree/transport/limiters.hpp>
#include <scree/transport/reconstructions/any_reconstruction.hpp>
#include <scree/transport/type_list.hpp>

#include <gtest/gtest.h>

namespace scree::transport::test {

template <class List>
struct TypesOf;
template <class... Entries>
struct TypesOf<TypeList<Entries...>> {
  using type = ::testing::Types<Entries...>;
};

/// A list of the library as the types of a typed suite.
template <class List>
using Types = typename TypesOf<List>::type;

template <class R>
struct OfAnyLimiter;
template <template <Limiter> class R, Limiter L>
struct OfAnyLimiter<R<L>> {
  template <class List>
  struct With;
  template <class... Limiters>
  struct With<TypeList<Limiters...>> {
    using type = AnyReconstruction<R<Limiters>...>;
  };
  using type = typename With<LimiterList>::type;
};

/// A reconstruction with any of the library's limiters in the place of its own: a suite over all of them
/// compiles one solver.
template <class R>
using WithAnyLimiter = typename OfAnyLimiter<R>::type;

}  // namespace scree::transport::test
