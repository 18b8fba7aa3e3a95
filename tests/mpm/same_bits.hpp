#pragma once

#include <scree/mpm/particles.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

namespace scree::mpm {

/// That all columns of two runs are alike to the last bit.
template <int D, int V>
void expect_same_bits(const Particles<D, V>& a, const Particles<D, V>& b) {
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  std::vector<const Column*> columns;
  b.for_each_column([&](const Column& column) { columns.push_back(&column); });
  std::size_t next = 0;
  a.for_each_column([&](const Column& column) {
    EXPECT_TRUE(std::ranges::equal(column.values(), columns[next++]->values(), {}, bits, bits))
        << column.quantity().name;
  });
}

}  // namespace scree::mpm
