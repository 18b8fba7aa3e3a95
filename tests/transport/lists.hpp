#pragma once

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

}  // namespace scree::transport::test
