#pragma once

#include <scree/wall_law.hpp>

#include <array>
#include <bit>
#include <cstddef>

namespace scree::mpm {

/// Which of the numbers that the law of a wall reads are means of what points carry; the others are the
/// wall's own.  @see Eq. (M170)
template <WallLaw Law>
class CarriedInput {
 public:
  using Input = typename Law::template Input<double>;
  static constexpr std::size_t num_inputs = Law::inputs.size();

  /// Nothing is carried.
  constexpr CarriedInput() noexcept { places_.fill(own); }

  /// Input number `input` of the law is the mean in a place that `NodeMeans` gave.
  constexpr void read(std::size_t input, std::size_t place) noexcept { places_[input] = place; }

  /// What the law reads at a node.  @param means of the node; not looked at if nothing is carried
  [[nodiscard]] Input at(const Input& of_wall, const double* means) const noexcept {
    if constexpr (num_inputs == 0) {
      return of_wall;
    } else {
      auto numbers = std::bit_cast<std::array<double, num_inputs>>(of_wall);
      for (std::size_t i = 0; i < num_inputs; ++i) {
        if (places_[i] != own) numbers[i] = means[places_[i]];
      }
      return std::bit_cast<Input>(numbers);
    }
  }

 private:
  static constexpr std::size_t own = static_cast<std::size_t>(-1);
  std::array<std::size_t, num_inputs> places_;
};

}  // namespace scree::mpm
