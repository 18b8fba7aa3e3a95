#pragma once

#include <scree/parameter.hpp>
#include <scree/transport/limiters.hpp>
#include <scree/transport/reconstructions.hpp>
#include <scree/transport/reconstructions/admissible.hpp>
#include <scree/transport/reconstructions/in_primitives.hpp>

#include <fmt/format.h>

#include <array>
#include <string>
#include <type_traits>

namespace scree::charts {

/// The sharpnesses of a limiter that has one to choose: gentlest, usual, steepest.
inline constexpr std::array<double, 3> thetas{1, 1.3, 2};

/// Calls visit(limiter, label) for a limiter as it comes, or for three values of its theta.
template <class L, class Visitor>
void for_each_variant(Visitor&& visit) {
  constexpr auto parameters = parameters_of<L>();
  if constexpr (parameters.size() == 1) {
    if (parameters[0].name == "theta") {
      for (const double theta : thetas) visit(L{theta}, fmt::format("{}({:g})", L::name, theta));
      return;
    }
  }
  visit(L{}, std::string{L::name});
}

/// Whether a reconstruction is another one in disguise where there is one component only.
template <class R>
inline constexpr bool is_for_systems_only = false;
template <transport::Limiter L>
inline constexpr bool is_for_systems_only<transport::PiecewiseLinearCommon<L>> = true;

namespace detail {
/// A reconstruction with every limiter that it may have.
template <class R>
struct Reconstructions {
  using Any = transport::AnyReconstruction<R>;

  template <class Visitor>
  static void visit_each(Visitor&& visit) {
    visit(R{}, std::string{});
  }
};

template <template <transport::Limiter> class R, transport::Limiter L>
struct Reconstructions<R<L>> {
  using Any = transport::WithAnyLimiter<R<L>>;

  template <class Visitor>
  static void visit_each(Visitor&& visit) {
    transport::for_each_entry(transport::LimiterList{}, [&]<class Other>() {
      for_each_variant<Other>(
          [&](const Other& limiter, const std::string& label) { visit(R<Other>{limiter}, label); });
    });
  }
};

/// One of all that several may be.
template <class... Anys>
struct Joined;
template <class... Rs>
struct Joined<transport::AnyReconstruction<Rs...>> {
  using type = transport::AnyReconstruction<Rs...>;
};
template <class... First, class... Second, class... Rest>
struct Joined<transport::AnyReconstruction<First...>, transport::AnyReconstruction<Second...>, Rest...>
    : Joined<transport::AnyReconstruction<First..., Second...>, Rest...> {};

template <int N, class R>
using Shown = std::conditional_t<(N > 1 || !is_for_systems_only<R>), typename Reconstructions<R>::Any,
                                 transport::AnyReconstruction<>>;

template <int N, class List>
struct AnyOfComponents;
template <int N, class... Rs>
struct AnyOfComponents<N, transport::TypeList<Rs...>> : Joined<Shown<N, Rs>...> {};

template <class Law, class Any>
struct AnyInPrimitives;
template <class Law, class... Rs>
struct AnyInPrimitives<Law, transport::AnyReconstruction<Rs...>> {
  using type = transport::AnyReconstruction<transport::Admissible<transport::InPrimitives<Rs, Law>, Law>...>;
};
}  // namespace detail

/// Calls visit(reconstruction, its name, label of its limiter) for every reconstruction of N components that
/// the library lists, with every limiter. All are of one type: a solver is compiled once for them.
template <int N, class Visitor>
void for_each_reconstruction(Visitor&& visit) {
  using Any = typename detail::AnyOfComponents<N, transport::ReconstructionList>::type;
  transport::for_each_entry(transport::ReconstructionList{}, [&]<class R>() {
    if constexpr (N > 1 || !is_for_systems_only<R>) {
      detail::Reconstructions<R>::visit_each([&](const auto& reconstruction, const std::string& label) {
        visit(Any{reconstruction}, std::string{R::name}, label);
      });
    }
  });
}

/// Calls visit(reconstruction, label of its limiter) for straight lines in the primitive variables of a law,
/// kept admissible: what the library takes for such a law untold, here with every limiter. All are of one
/// type.
template <class Law, class Visitor>
void for_each_reconstruction_in_primitives(const Law& law, Visitor&& visit) {
  using Linear = detail::Reconstructions<transport::PiecewiseLinear<transport::Minmod>>;
  using Any = typename detail::AnyInPrimitives<Law, typename Linear::Any>::type;
  Linear::visit_each([&](const auto& linear, const std::string& label) {
    visit(Any{transport::Admissible{transport::InPrimitives{linear, law}, law}}, label);
  });
}

}  // namespace scree::charts
