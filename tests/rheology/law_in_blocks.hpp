#pragma once

#include <scree/instruction_set.hpp>
#include <scree/law_block.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scree::rheology {

/// Of components in a tensor, row by row.
using Places = std::span<const std::size_t>;

/// Points with a column for each number: L row by row, density, inputs, states, then the stress row by row.
using Numbers = std::vector<std::vector<double>>;

/// Whether component i of a tensor, row by row, is one that a flow in a plane, or of axial symmetry, lacks.
[[nodiscard]] inline bool is_out_of_plane(std::size_t i) {
  return std::ranges::find(out_of_plane, i) != out_of_plane.end();
}

/// One law of the list over blocks and batches of points, whatever its type: tests of it are compiled once.
struct LawInBlocks {
  std::string name;
  std::array<double, 4> densities{};             ///< from disconnected to compressed [kg/m^3]
  std::vector<double> inputs;                    ///< of an ordinary point
  std::vector<double> states;                    ///< of material that has not been deformed yet
  std::vector<std::string_view> units_of_state;  ///< of each state
  bool remembers_strain = false;                 ///< an elastic one, in its first six states
  bool has_plane_form = false;                   ///< and so rounds otherwise in a plane
  std::function<bool(InstructionSet)> has_kernel;
  /// Updates points over a step [s], by the kernel for a set; in a plane only the components that it has are
  /// read and written.
  std::function<BlockStiffness(InstructionSet, Numbers&, double dt, bool is_plane)> update;
  /// The same where components of the gradient are absent, and those of the stress not wanted.
  std::function<BlockStiffness(InstructionSet, Numbers&, double dt, Places absent)> update_without;
  /// As `update`, in doubles.
  std::function<BlockStiffness(Numbers&, double dt, bool is_plane)> update_by_points;
  /// The same of the first points of the columns, any number of them; of the stress above its diagonal.
  std::function<BlockStiffness(InstructionSet, Numbers&, std::size_t num_points, double dt, bool is_plane)>
      update_batch;
  std::function<void(Numbers&)> validate_columns;

  static constexpr std::size_t density = 9;  ///< its column
  [[nodiscard]] std::size_t first_state() const { return 10 + inputs.size(); }
  [[nodiscard]] std::size_t num_arguments() const { return first_state() + states.size(); }

  /// Points of unlike density, gradient and size, in their third step, of a flow in a plane or of any;
  /// their number is one of whole packs.
  [[nodiscard]] Numbers some_points(std::size_t num_points, double dt, bool is_plane = false) const;
};

/// Every law of the list, and the one of a name.
[[nodiscard]] std::vector<LawInBlocks> laws_in_blocks();
[[nodiscard]] LawInBlocks law_in_blocks(std::string_view name);

}  // namespace scree::rheology
