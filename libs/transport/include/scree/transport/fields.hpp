#pragma once

#include <scree/blocks.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <new>
#include <span>
#include <vector>

namespace scree::transport {

namespace detail {

/// Memory that starts a line of the cache, so that whole vectors do not straddle two.
template <class T>
struct LineAllocator {
  using value_type = T;
  static constexpr std::align_val_t line{64};

  LineAllocator() = default;
  template <class U>
  LineAllocator(const LineAllocator<U>& /*other*/) noexcept {}  // not explicit: allocators are rebound

  [[nodiscard]] T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), line)); }
  void deallocate(T* memory, std::size_t /*n*/) noexcept { ::operator delete(memory, line); }
  [[nodiscard]] bool operator==(const LineAllocator& /*other*/) const noexcept { return true; }
};

}  // namespace detail

/// N values per site, one contiguous row of all sites per component, so that loops over sites run over
/// neighbours in memory. (Callers keep theirs the other way round, component fastest.)
template <int N>
class Fields {
 public:
  explicit Fields(Index num_sites)
      : num_sites_{num_sites},
        stride_{(num_sites + padding) / per_line * per_line},
        values_(static_cast<std::size_t>(N * stride_)) {}

  [[nodiscard]] Index num_sites() const noexcept { return num_sites_; }
  /// Distance between two components of one site.
  [[nodiscard]] Index stride() const noexcept { return stride_; }
  [[nodiscard]] double* data() noexcept { return values_.data(); }
  [[nodiscard]] const double* data() const noexcept { return values_.data(); }
  [[nodiscard]] std::span<double> all() noexcept { return values_; }
  [[nodiscard]] std::span<const double> all() const noexcept { return values_; }

  [[nodiscard]] std::array<double, static_cast<std::size_t>(N)> operator[](Index site) const noexcept {
    std::array<double, static_cast<std::size_t>(N)> u;
    for (int k = 0; k < N; ++k) u[static_cast<std::size_t>(k)] = values_[offset(k, site)];
    return u;
  }

  /// Copies values in. @param source num_sites x N, component fastest.
  void gather(std::span<const double> source, Threads threads) {
    for_each_chunk(threads, [&](Index begin, Index end) {
      for (int k = 0; k < N; ++k) {
        for (Index site = begin; site < end; ++site) {
          values_[offset(k, site)] = source[static_cast<std::size_t>(site * N + k)];
        }
      }
    });
  }

  /// Copies values out, at the sites where `is_kept(site)`. @param target num_sites x N, component fastest.
  template <class Predicate>
  void scatter(std::span<double> target, Threads threads, Predicate&& is_kept) const {
    for_each_chunk(threads, [&](Index begin, Index end) {
      for (Index site = begin; site < end; ++site) {
        if (!is_kept(site)) continue;
        for (int k = 0; k < N; ++k) target[static_cast<std::size_t>(site * N + k)] = values_[offset(k, site)];
      }
    });
  }

 private:
  // Rows start a line of the cache. A power of two apart they would share their places in it: some lines
  // more.
  static constexpr Index per_line = 8;
  static constexpr Index padding = 47;
  static constexpr Index chunk = 4096;

  [[nodiscard]] std::size_t offset(int component, Index site) const noexcept {
    return static_cast<std::size_t>(component * stride_ + site);
  }

  template <class Body>
  void for_each_chunk(Threads threads, Body&& body) const {
    for_each_block((num_sites_ + chunk - 1) / chunk, threads,
                   [&](Index block) { body(block * chunk, std::min(num_sites_, (block + 1) * chunk)); });
  }

  Index num_sites_;
  Index stride_;
  std::vector<double, detail::LineAllocator<double>> values_;
};

}  // namespace scree::transport
