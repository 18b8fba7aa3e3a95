#pragma once

#include <scree/blocks.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace scree::transport {

/// N values per cell, those of one cell together: what an unstructured mesh reads of a neighbour is in one
/// place. (Fields, for lattices, keeps one row per component.)
template <int N>
class CellStates {
 public:
  using State = std::array<double, static_cast<std::size_t>(N)>;

  explicit CellStates(Index num_cells) : values_(static_cast<std::size_t>(N * num_cells)) {}

  [[nodiscard]] double* data() noexcept { return values_.data(); }
  [[nodiscard]] const double* data() const noexcept { return values_.data(); }
  [[nodiscard]] std::span<double> all() noexcept { return values_; }
  [[nodiscard]] std::span<const double> all() const noexcept { return values_; }

  [[nodiscard]] State operator[](Index cell) const noexcept {
    const double* values = values_.data() + cell * N;
    State u;
    for (int k = 0; k < N; ++k) u[static_cast<std::size_t>(k)] = values[k];
    return u;
  }

  /// Copies values in. @param source num_cells x N, component fastest.
  void gather(std::span<const double> source, Threads threads) {
    for_each_chunk(threads, [&](std::size_t begin, std::size_t count) {
      std::copy_n(source.begin() + static_cast<Index>(begin), count,
                  values_.begin() + static_cast<Index>(begin));
    });
  }

  /// Copies values out, at the cells where `is_kept(cell)`. @param target num_cells x N, component fastest.
  template <class Predicate>
  void scatter(std::span<double> target, Threads threads, Predicate&& is_kept) const {
    for_each_chunk(threads, [&](std::size_t begin, std::size_t count) {
      for (std::size_t i = begin; i < begin + count; ++i) {
        if (is_kept(static_cast<Index>(i / N))) target[i] = values_[i];
      }
    });
  }

 private:
  static constexpr std::size_t chunk = std::size_t{4096} * N;

  template <class Body>
  void for_each_chunk(Threads threads, Body&& body) const {
    const std::size_t num_chunks = (values_.size() + chunk - 1) / chunk;
    for_each_block(static_cast<Index>(num_chunks), threads, [&](Index block) {
      const std::size_t begin = static_cast<std::size_t>(block) * chunk;
      body(begin, std::min(chunk, values_.size() - begin));
    });
  }

  std::vector<double> values_;
};

}  // namespace scree::transport
