#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace scree {

/// Allocates on cache lines, so that a pack of doubles at a multiple of its size never lies across two of
/// them.
template <class T>
struct CacheAligned {
  using value_type = T;
  static constexpr std::align_val_t line{64};  ///< [bytes]

  CacheAligned() = default;
  template <class U>
  CacheAligned(const CacheAligned<U>& /*other*/) noexcept {}  // NOLINT(google-explicit-constructor): rebinds

  /// @throws std::bad_alloc
  [[nodiscard]] T* allocate(std::size_t count) {
    return static_cast<T*>(::operator new(count * sizeof(T), line));
  }
  void deallocate(T* memory, std::size_t /*count*/) noexcept { ::operator delete(memory, line); }

  friend bool operator==(const CacheAligned& /*a*/, const CacheAligned& /*b*/) noexcept { return true; }
};

/// A vector that begins on a cache line.
template <class T>
using AlignedVector = std::vector<T, CacheAligned<T>>;

}  // namespace scree
