#pragma once

#include "vector_functions.hpp"

#include <scree/rheology/elementary.hpp>

#include <cmath>

// Two packs as one number. A law is a chain of operations that wait for each other; two such chains side by
// side fill each other's waits. A plain pair, whose halves stay in registers: `fixed_size_simd` keeps its
// parts in an array, through memory.

namespace scree::rheology::SCREE_INSTRUCTION_SET {

/// A truth for each lane of two packs.
template <class Mask>
struct TwoMasks {
  Mask low, high;

  [[nodiscard]] friend TwoMasks operator!(const TwoMasks& a) noexcept { return {!a.low, !a.high}; }
  [[nodiscard]] friend TwoMasks operator&&(const TwoMasks& a, const TwoMasks& b) noexcept {
    return {a.low && b.low, a.high && b.high};
  }
  [[nodiscard]] friend TwoMasks operator||(const TwoMasks& a, const TwoMasks& b) noexcept {
    return {a.low || b.low, a.high || b.high};
  }
  [[nodiscard]] friend bool any_of(const TwoMasks& a) noexcept { return any_of(a.low || a.high); }
  [[nodiscard]] friend bool all_of(const TwoMasks& a) noexcept { return all_of(a.low && a.high); }
};

/// The lanes of two packs, those of `low` first. All that laws ask of a number, half by half.
template <class Pack>
struct TwoPacks {
  using Mask = TwoMasks<typename Pack::mask_type>;

  Pack low, high;

  TwoPacks() = default;
  TwoPacks(double of_all) noexcept
      : low(of_all), high(of_all) {}  // NOLINT(google-explicit-constructor): as a pack
  TwoPacks(const Pack& first, const Pack& second) noexcept : low(first), high(second) {}

  [[nodiscard]] friend TwoPacks operator-(const TwoPacks& a) noexcept { return {-a.low, -a.high}; }
  [[nodiscard]] friend TwoPacks operator+(const TwoPacks& a, const TwoPacks& b) noexcept {
    return {a.low + b.low, a.high + b.high};
  }
  [[nodiscard]] friend TwoPacks operator-(const TwoPacks& a, const TwoPacks& b) noexcept {
    return {a.low - b.low, a.high - b.high};
  }
  [[nodiscard]] friend TwoPacks operator*(const TwoPacks& a, const TwoPacks& b) noexcept {
    return {a.low * b.low, a.high * b.high};
  }
  [[nodiscard]] friend TwoPacks operator/(const TwoPacks& a, const TwoPacks& b) noexcept {
    return {a.low / b.low, a.high / b.high};
  }
  [[nodiscard]] friend Mask operator<(const TwoPacks& a, const TwoPacks& b) noexcept {
    return {a.low < b.low, a.high < b.high};
  }
  [[nodiscard]] friend Mask operator<=(const TwoPacks& a, const TwoPacks& b) noexcept {
    return {a.low <= b.low, a.high <= b.high};
  }
  [[nodiscard]] friend Mask operator>(const TwoPacks& a, const TwoPacks& b) noexcept { return b < a; }
  [[nodiscard]] friend Mask operator>=(const TwoPacks& a, const TwoPacks& b) noexcept { return b <= a; }
  [[nodiscard]] friend Mask operator==(const TwoPacks& a, const TwoPacks& b) noexcept {
    return {a.low == b.low, a.high == b.high};
  }
  [[nodiscard]] friend TwoPacks sqrt(const TwoPacks& a) noexcept {
    using std::sqrt;
    return {sqrt(a.low), sqrt(a.high)};
  }

  /// What `where(mask, pack) = ..` of a pack is, for `select`.
  struct Chosen {
    const Mask& mask;
    TwoPacks& numbers;

    void operator=(const TwoPacks& other) && noexcept {
      where(mask.low, numbers.low) = other.low;
      where(mask.high, numbers.high) = other.high;
    }
  };
  [[nodiscard]] friend Chosen where(const Mask& mask, TwoPacks& numbers) noexcept { return {mask, numbers}; }
};

}  // namespace scree::rheology::SCREE_INSTRUCTION_SET

namespace scree::rheology::elementary {

template <class Pack>
struct Functions<SCREE_INSTRUCTION_SET::TwoPacks<Pack>> {
  using Numbers = SCREE_INSTRUCTION_SET::TwoPacks<Pack>;
  using Half = Functions<Pack>;

  [[nodiscard]] static Numbers exp(const Numbers& x) noexcept {
    return {Half::exp(x.low), Half::exp(x.high)};
  }
  [[nodiscard]] static Numbers expm1(const Numbers& x) noexcept {
    return {Half::expm1(x.low), Half::expm1(x.high)};
  }
  [[nodiscard]] static Numbers log(const Numbers& x) noexcept {
    return {Half::log(x.low), Half::log(x.high)};
  }
  [[nodiscard]] static Numbers pow(const Numbers& base, const Numbers& exponent) noexcept {
    return {Half::pow(base.low, exponent.low), Half::pow(base.high, exponent.high)};
  }
};

}  // namespace scree::rheology::elementary
