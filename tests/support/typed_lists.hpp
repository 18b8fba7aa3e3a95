#pragma once

#include <gtest/gtest.h>

#include <string>

namespace scree::testing {

/// The entries of a library's list (a variant, or any list of types) as types of a TYPED_TEST_SUITE: what is
/// in the list is what is tested.
template <class List>
struct TypesOf;
template <template <class...> class List, class... Entries>
struct TypesOf<List<Entries...>> {
  using type = ::testing::Types<Entries...>;
};
template <class List>
using Each = typename TypesOf<List>::type;

/// Names each instance of a typed suite for its entry in the list.
struct EntryName {
  template <class Entry>
  static std::string GetName(int /*number*/) {
    return std::string{Entry::name};
  }
};

}  // namespace scree::testing
