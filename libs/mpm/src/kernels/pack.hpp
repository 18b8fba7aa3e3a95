#pragma once

#include <cstddef>
#if defined(__AVX__)
#include <immintrin.h>
#endif

/// Stands before a kernel: all that it calls becomes part of it, or the compiler would inline the less the
/// more kernels there are. Not under the sanitizers, as it would take them four times as long to compile.
#if defined(__SANITIZE_ADDRESS__)
#define SCREE_KERNEL
#else
#define SCREE_KERNEL [[gnu::flatten]]
#endif

/// Registers of several doubles, in the namespace of the instruction set that they belong to: so nothing that
/// is made of them can be taken for code of another set.
namespace scree::mpm::SCREE_INSTRUCTION_SET {

#if defined(__AVX512F__)
inline constexpr int register_size = 8;
#elif defined(__AVX__)
inline constexpr int register_size = 4;
#else
inline constexpr int register_size = 2;
#endif

/// A double for each of some neighbouring points: a number of pointwise physics.
class Pack {
 public:
  static constexpr int size = register_size;
  using Register [[gnu::vector_size(size * sizeof(double))]] = double;
  using Mask = decltype(Register{} < Register{});  ///< all bits of a lane, or none

  Pack() = default;
  Pack(double value) noexcept
      : lanes_{value - Register{}} {}  // NOLINT(google-explicit-constructor): a number
  explicit Pack(const Register& lanes) noexcept : lanes_{lanes} {}

  [[nodiscard]] static Pack load(const double* from) noexcept {
    const Register lanes = *reinterpret_cast<const Anywhere*>(from);
    return Pack{lanes};
  }
  void store(double* to) const noexcept { *reinterpret_cast<Anywhere*>(to) = lanes_; }

  [[nodiscard]] double operator[](int lane) const noexcept { return lanes_[lane]; }
  [[nodiscard]] const Register& lanes() const noexcept { return lanes_; }

  friend Pack operator+(const Pack& a, const Pack& b) noexcept { return Pack{a.lanes_ + b.lanes_}; }
  friend Pack operator-(const Pack& a, const Pack& b) noexcept { return Pack{a.lanes_ - b.lanes_}; }
  friend Pack operator*(const Pack& a, const Pack& b) noexcept { return Pack{a.lanes_ * b.lanes_}; }
  friend Pack operator/(const Pack& a, const Pack& b) noexcept { return Pack{a.lanes_ / b.lanes_}; }
  friend Pack operator-(const Pack& a) noexcept { return Pack{-a.lanes_}; }

  friend Mask operator<(const Pack& a, const Pack& b) noexcept { return a.lanes_ < b.lanes_; }
  friend Mask operator==(const Pack& a, const Pack& b) noexcept { return a.lanes_ == b.lanes_; }
  friend Mask operator<=(const Pack& a, const Pack& b) noexcept { return a.lanes_ <= b.lanes_; }

  friend Pack max(const Pack& a, const Pack& b) noexcept {
    return Pack{a.lanes_ < b.lanes_ ? b.lanes_ : a.lanes_};
  }
  friend Pack min(const Pack& a, const Pack& b) noexcept {
    return Pack{a.lanes_ < b.lanes_ ? a.lanes_ : b.lanes_};
  }
  /// `a` where the mask is set, else `b`.
  friend Pack select(const Mask& mask, const Pack& a, const Pack& b) noexcept {
    return Pack{mask ? a.lanes_ : b.lanes_};
  }
  friend Pack abs(const Pack& a) noexcept { return max(a, -a); }

  /// Of numbers that an int can hold: a cell, not a place.
  friend Pack floor(const Pack& a) noexcept {
#if defined(__AVX512F__)
    return Pack{_mm512_floor_pd(a.lanes_)};
#elif defined(__AVX__)
    return Pack{_mm256_floor_pd(a.lanes_)};
#else
    using Ints [[gnu::vector_size(size * sizeof(int))]] = int;
    const Register whole = __builtin_convertvector(__builtin_convertvector(a.lanes_, Ints), Register);
    return Pack{whole > a.lanes_ ? whole - 1 : whole};
#endif
  }

  /// The least of all lanes, in each; any number if one is NaN.
  friend Pack least_lane(const Pack& a) noexcept {
#if defined(__AVX512F__)
    return Pack{_mm512_reduce_min_pd(a.lanes_)};
#elif defined(__AVX__)
    const Pack halves = min(a, Pack{__builtin_shufflevector(a.lanes_, a.lanes_, 2, 3, 0, 1)});
    return min(halves, Pack{__builtin_shufflevector(halves.lanes_, halves.lanes_, 1, 0, 3, 2)});
#else
    return min(a, Pack{__builtin_shufflevector(a.lanes_, a.lanes_, 1, 0)});
#endif
  }
  friend Pack largest_lane(const Pack& a) noexcept {
    return -least_lane(-a);
  }
  [[nodiscard]] static bool all_of(const Mask& mask) noexcept {
#if defined(__AVX512F__)
    return _mm512_test_epi64_mask(reinterpret_cast<__m512i>(mask), reinterpret_cast<__m512i>(mask)) == 0xff;
#elif defined(__AVX__)
    return _mm256_movemask_pd(reinterpret_cast<Register>(mask)) == 0xf;
#else
    return (mask[0] & mask[1]) != 0;
#endif
  }

 private:
  /// A register's doubles anywhere in an array. GCC moves as many bytes, std::memcpy's, in halves unless all
  /// of AVX-512 is there, and then keeps in memory whatever consists of packs.
  using Anywhere [[gnu::vector_size(size * sizeof(double)), gnu::aligned(alignof(double)), gnu::may_alias]] =
      double;
  Register lanes_;
};

/// Four neighbouring doubles: fields of one node.
class Four {
 public:
#if defined(__AVX__)
  static constexpr int num_parts = 1;
#else
  static constexpr int num_parts = 2;
#endif
  using Part [[gnu::vector_size(4 * sizeof(double) / num_parts)]] = double;

  Four() = default;
  [[nodiscard]] static Four zero() noexcept {
    Four four;
    for (Part& part : four.parts_) part = Part{};
    return four;
  }
  [[nodiscard]] static Four load(const double* from) noexcept {
    Four four;
    for (int i = 0; i < num_parts; ++i) four.parts_[i] = reinterpret_cast<const Anywhere*>(from)[i];
    return four;
  }
  void store(double* to) const noexcept {
    for (int i = 0; i < num_parts; ++i) reinterpret_cast<Anywhere*>(to)[i] = parts_[i];
  }

  Four& operator+=(const Four& other) noexcept {
    for (int i = 0; i < num_parts; ++i) parts_[i] += other.parts_[i];
    return *this;
  }
  friend Four operator+(Four a, const Four& b) noexcept {
    return a += b;
  }
  friend Four operator*(double factor, Four a) noexcept {
    for (Part& part : a.parts_) part *= factor;
    return a;
  }

 private:
  using Anywhere [[gnu::vector_size(sizeof(Part)), gnu::aligned(alignof(double)), gnu::may_alias]] = double;
  Part parts_[num_parts];
};

}  // namespace scree::mpm::SCREE_INSTRUCTION_SET
