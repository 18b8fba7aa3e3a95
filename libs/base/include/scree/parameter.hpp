#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <string_view>
#include <type_traits>
#include <utility>

namespace scree {

/// A number that a model is made from, described for people and for readers of scenes.
struct Parameter {
  std::string_view name;                                       ///< key in a scene
  std::string_view unit;                                       ///< SI; "-" if it has none
  std::string_view meaning;                                    ///< in a few words
  double fallback = std::numeric_limits<double>::quiet_NaN();  ///< NaN: it must be given
};

/// The parameters of a model in the order of its constructor: its static member `parameters`, or none.
template <class Model>
[[nodiscard]] constexpr auto parameters_of() noexcept {
  if constexpr (requires { Model::parameters; }) {
    return Model::parameters;
  } else {
    return std::array<Parameter, 0>{};
  }
}

/// The model with the given values of its parameters, in their order.  @throws what its constructor throws.
template <class Model, std::size_t N>
[[nodiscard]] Model make_model(const std::array<double, N>& values) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return Model{values[I]...};
  }
  (std::make_index_sequence<N>{});
}

}  // namespace scree
