#pragma once

#include <scree/transport/components.hpp>
#include <scree/transport/concepts.hpp>
#include <scree/transport/limiters/minmod.hpp>
#include <scree/transport/reconstructions/any_reconstruction.hpp>
#include <scree/transport/reconstructions/piecewise_linear.hpp>

namespace scree::transport {

/// Another reconstruction, of the primitive variables of a law: positive density and pressure of the cells
/// give positive ones at the faces, and pressure and velocity stay uniform through a contact.
///
/// Conservation is untouched: the cells' values stay what they are. But the mean of both faces is not the
/// cell's, so this alone does not promise positive cells: Admissible does.
/// @see Eq. (T22)
template <class R, HasPrimitives Law>
struct InPrimitives {
  static_assert(!is_chosen_at_run_time<R>,
                "put AnyReconstruction round several InPrimitives, not inside one");
  static constexpr std::string_view name = "in_primitives";
  static constexpr std::string_view summary = "another reconstruction, of the primitive variables";
  static constexpr bool keeps_mean = false;

  R reconstruction{};
  Law law{};  ///< whose variables

  using State = typename Law::State;

  [[nodiscard]] Edges<State> operator()(const State& below, const State& here,
                                        const State& above) const noexcept {
    const Edges<State> edges =
        reconstruction(law.primitive(below), law.primitive(here), law.primitive(above));
    return {law.conserved(edges.low), law.conserved(edges.high)};
  }

  /// The same round another reconstruction, such as one for unequal cells.
  template <class Other>
  [[nodiscard]] InPrimitives<Other, Law> around(const Other& other) const noexcept {
    return {other, law};
  }

  [[nodiscard]] double promised_cfl() const noexcept { return reconstruction.promised_cfl(); }
};
template <class R, class Law>
InPrimitives(R, Law) -> InPrimitives<R, Law>;

}  // namespace scree::transport
