#pragma once

#include <scree/error.hpp>
#include <scree/index.hpp>
#include <scree/wall_law.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

namespace scree::mpm {

/// Which of the numbers that the law of a wall reads are means of what points carry; the others are the
/// wall's own. A run in which any is read needs `Stages::node_means`, which gave the places.
/// @see Eq. (M170)
template <WallLaw Law>
class CarriedInput {
 public:
  using Input = typename Law::template Input<double>;
  static constexpr std::size_t num_inputs = Law::inputs.size();

  /// Nothing is carried.
  constexpr CarriedInput() noexcept { places_.fill(own); }

  /// Input number `input` of the law is the mean in a place that `NodeMeans` gave.
  constexpr void read(std::size_t input, std::size_t place) noexcept { places_[input] = place; }

  /// How many means a node must have for it: one past the last that is read; 0 if nothing is carried.
  [[nodiscard]] constexpr Index num_means() const noexcept {
    std::size_t count = 0;
    for (const std::size_t place : places_) count = place == own ? count : std::max(count, place + 1);
    return static_cast<Index>(count);
  }

  /// What the law reads at a node.  @param means num_means() of them or more; not looked at if nothing is
  /// carried
  [[nodiscard]] Input at(const Input& of_wall, const double* means) const noexcept {
    if constexpr (num_inputs == 0) {
      return of_wall;
    } else {
      auto numbers = std::bit_cast<std::array<double, num_inputs>>(of_wall);
      for (std::size_t i = 0; i < num_inputs; ++i) {
        if (places_[i] == own) continue;
        SCREE_ASSERT(means != nullptr);
        numbers[i] = means[places_[i]];
      }
      return std::bit_cast<Input>(numbers);
    }
  }

 private:
  static constexpr std::size_t own = static_cast<std::size_t>(-1);
  std::array<std::size_t, num_inputs> places_;
};

}  // namespace scree::mpm
