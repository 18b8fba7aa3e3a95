#pragma once

#include "points.hpp"

#include <scree/rheology/concepts.hpp>
#include <scree/update_block.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace scree::rheology {

/// Points with a column for each number: L row by row, density, inputs, states, then the stress row by row.
using Numbers = std::vector<std::vector<double>>;

/// One law of the list over blocks of points, whatever its type: tests of it are compiled once.
struct LawInBlocks {
  std::string name;
  std::array<double, 4> densities{};             ///< from disconnected to compressed [kg/m^3]
  std::vector<double> inputs;                    ///< of an ordinary point
  std::vector<double> states;                    ///< of material that has not been deformed yet
  std::vector<std::string_view> units_of_state;  ///< of each state
  std::function<bool(InstructionSet)> has_kernel;
  /// Updates points over a step [s], by the kernel for a set; in a plane only the components that it has are
  /// read and written.
  std::function<BlockStiffness(InstructionSet, Numbers&, double dt, bool is_plane)> update;
  std::function<BlockStiffness(Numbers&, double dt)> update_by_points;  ///< the same, in doubles

  static constexpr std::size_t density = 9;  ///< its column
  [[nodiscard]] std::size_t first_state() const { return 10 + inputs.size(); }
  [[nodiscard]] std::size_t num_arguments() const { return first_state() + states.size(); }
};

namespace detail {
template <class Law>
[[nodiscard]] LawBlock<Law> block_of(Numbers& numbers, bool is_plane) {
  LawBlock<Law> block;
  block.num_points = static_cast<Index>(numbers.front().size());
  std::size_t column = 10;
  block.density = numbers[9].data();
  for (auto& input : block.inputs) input = numbers[column++].data();
  for (auto& state : block.states) state = numbers[column++].data();
  for (std::size_t i = 0; i < 9; ++i, ++column) {
    if (is_plane && (i % 3 == 2 || i > 5)) continue;
    block.velocity_gradient[i] = {numbers[i].data(), 1};
    block.stress[i] = numbers[column].data();
  }
  return block;
}
}  // namespace detail

template <class Law>
[[nodiscard]] LawInBlocks in_blocks() {
  const Law law = typical<Law>();
  LawInBlocks result;
  result.name = Law::name;
  result.densities = rheology::densities(law);
  for (const InputColumn& input : Law::inputs) result.inputs.push_back(input.typical);
  for (const StateColumn& state : Law::states) {
    result.states.push_back(state.initial);
    result.units_of_state.push_back(state.unit);
  }
  result.has_kernel = [law](InstructionSet set) { return block_kernel(law, set) != nullptr; };
  result.update = [law](InstructionSet set, Numbers& numbers, double dt, bool is_plane) {
    return block_kernel(law, set)(law, detail::block_of<Law>(numbers, is_plane), dt);
  };
  result.update_by_points = [law](Numbers& numbers, double dt) {
    return update_block<double>(law, detail::block_of<Law>(numbers, false), dt);
  };
  return result;
}

}  // namespace scree::rheology
