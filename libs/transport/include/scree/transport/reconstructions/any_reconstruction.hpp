#pragma once

#include <scree/transport/concepts.hpp>

#include <string_view>
#include <utility>
#include <variant>

namespace scree::transport {

/// One of several reconstructions, chosen at run time: a solver asks once a row of cells which it is.
///
/// The same bits as that one alone, and a solver is compiled once for all of them. It is the outermost: of
/// `Admissible` and `InPrimitives` it holds several, and they refuse to hold it. What one of several needs
/// (equal cells), or does not promise (bounds), holds for all.
template <class... Rs>
struct AnyReconstruction {
  static constexpr std::string_view name = "any_reconstruction";
  static constexpr std::string_view summary = "one of several reconstructions, chosen at run time";
  static constexpr bool needs_equal_cells = (transport::needs_equal_cells<Rs> || ...);
  static constexpr bool leaves_bounds = (transport::leaves_bounds<Rs> || ...);

  std::variant<Rs...> choice{};

  template <class State>
  [[nodiscard]] Edges<State> operator()(const State& below, const State& here,
                                        const State& above) const noexcept {
    return std::visit([&](const auto& chosen) -> Edges<State> { return chosen(below, here, above); }, choice);
  }

  [[nodiscard]] double promised_cfl() const noexcept {
    return std::visit([](const auto& chosen) { return chosen.promised_cfl(); }, choice);
  }
};

template <class R>
constexpr bool is_chosen_at_run_time = false;
template <class... Rs>
constexpr bool is_chosen_at_run_time<AnyReconstruction<Rs...>> = true;

}  // namespace scree::transport
