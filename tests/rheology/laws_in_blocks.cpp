#include "law_in_blocks.hpp"
#include "points.hpp"

#include <scree/rheology/batch.hpp>
#include <scree/rheology/laws.hpp>

#include <algorithm>
#include <span>
#include <type_traits>
#include <variant>

namespace scree::rheology {

namespace {

[[nodiscard]] Places absent_from(bool is_plane) {
  return is_plane ? Places{out_of_plane} : Places{};
}

template <class Law>
[[nodiscard]] LawBlock<Law> block_of(Numbers& numbers, Places absent) {
  LawBlock<Law> block;
  block.num_points = static_cast<Index>(numbers.front().size());
  std::size_t column = 10;
  block.density = numbers[9].data();
  for (auto& input : block.inputs) input = numbers[column++].data();
  for (auto& state : block.states) state = numbers[column++].data();
  for (std::size_t i = 0; i < 9; ++i, ++column) {
    if (std::ranges::find(absent, i) != absent.end()) continue;
    block.velocity_gradient[i] = {numbers[i].data(), 1};
    block.stress[i] = numbers[column].data();
  }
  return block;
}

template <class Law>
[[nodiscard]] LawColumns<Law> columns_of(Numbers& numbers, std::size_t num_points, bool is_plane) {
  LawColumns<Law> columns;
  std::size_t next = 0;
  const auto first_of = [&](std::vector<double>& all) {
    return std::span{all}.first(std::min(num_points, all.size()));
  };
  const auto column = [&] { return first_of(numbers[next++]); };
  for (std::size_t i = 0; i < 9; ++i) {
    const auto gradient = column();
    if (!is_plane || !is_out_of_plane(i)) columns.velocity_gradient[i] = gradient;
  }
  columns.density = column();
  for (auto& input : columns.inputs) input = column();
  for (auto& state : columns.states) state = column();
  for (std::size_t i = 0; i < 6; ++i) {
    const std::size_t place = detail::places_of_stress[i];
    if (!is_plane || !is_out_of_plane(place)) columns.stress[i] = first_of(numbers[next + place]);
  }
  return columns;
}

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
  if constexpr (!Law::states.empty()) result.remembers_strain = Law::states[0].name == "elastic_strain_xx";
  result.has_plane_form = HasPlaneForm<Law>;
  result.has_kernel = [law](InstructionSet set) { return block_kernel(law, set) != nullptr; };
  result.update = [law](InstructionSet set, Numbers& numbers, double dt, bool is_plane) {
    return block_kernel(law, set)(law, block_of<Law>(numbers, absent_from(is_plane)), dt);
  };
  result.update_without = [law](InstructionSet set, Numbers& numbers, double dt, Places absent) {
    return block_kernel(law, set)(law, block_of<Law>(numbers, absent), dt);
  };
  result.update_by_points = [law](Numbers& numbers, double dt, bool is_plane) {
    return update_block<double>(law, block_of<Law>(numbers, absent_from(is_plane)), dt);
  };
  result.update_batch = [law](InstructionSet set, Numbers& numbers, std::size_t num_points, double dt,
                              bool is_plane) {
    return rheology::update_batch(law, columns_of<Law>(numbers, num_points, is_plane), dt, set);
  };
  result.validate_columns = [](Numbers& numbers) {
    rheology::validate_columns(columns_of<Law>(numbers, numbers.front().size(), false));
  };
  return result;
}

template <class... Laws>
[[nodiscard]] std::vector<LawInBlocks> each(std::type_identity<std::variant<Laws...>> /*list*/) {
  return {in_blocks<Laws>()...};
}

}  // namespace

std::vector<LawInBlocks> laws_in_blocks() {
  return each(std::type_identity<AnyLaw>{});
}

LawInBlocks law_in_blocks(std::string_view name) {
  const auto laws = laws_in_blocks();
  return *std::ranges::find(laws, name, &LawInBlocks::name);
}

Numbers LawInBlocks::some_points(std::size_t num_points, double dt, bool is_plane) const {
  Numbers numbers(num_arguments() + 9, std::vector<double>(num_points));
  const auto gradients = velocity_gradients();
  for (std::size_t p = 0; p < num_points; ++p) {
    for (std::size_t i = 0; i < 9; ++i) {
      numbers[i][p] = is_plane && is_out_of_plane(i) ? 0 : gradients[p % 8].components[i];
    }
    numbers[density][p] = densities[(p + p / 8) % 4];
    const double times = 1 - static_cast<double>(p) / 32;
    for (std::size_t i = 0; i < inputs.size(); ++i) numbers[10 + i][p] = times * inputs[i];
    for (std::size_t i = 0; i < states.size(); ++i) numbers[first_state() + i][p] = states[i];
    if (remembers_strain && p % 3 == 0) {  // beyond the series that smaller ones go by
      constexpr std::array<double, 6> strain{0.3, -0.1, -0.2, 0.1, 0.05, -0.05};
      for (std::size_t i = 0; i < (is_plane ? 4 : 6); ++i) numbers[first_state() + i][p] = strain[i];
    }
  }
  for (int n = 0; n < 2; ++n) update_by_points(numbers, dt, is_plane);
  return numbers;
}

}  // namespace scree::rheology
