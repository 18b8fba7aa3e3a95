#pragma once

#include <scree/parameter.hpp>
#include <scree/transport/limiters.hpp>
#include <scree/transport/reconstructions.hpp>
#include <scree/transport/reconstructions/admissible.hpp>
#include <scree/transport/reconstructions/in_primitives.hpp>

#include <fmt/format.h>

#include <array>
#include <string>

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

namespace detail {
template <class R>
struct Reconstructions {
  template <class Visitor>
  static void visit_each(Visitor&& visit) {
    visit(R{}, std::string{});
  }
};

template <template <transport::Limiter> class R, transport::Limiter Any>
struct Reconstructions<R<Any>> {
  template <class Visitor>
  static void visit_each(Visitor&& visit) {
    transport::for_each_entry(transport::LimiterList{}, [&]<class L>() {
      for_each_variant<L>([&](const L& limiter, const std::string& label) { visit(R<L>{limiter}, label); });
    });
  }
};
}  // namespace detail

/// Whether a reconstruction is another one in disguise where there is one component only.
template <class R>
inline constexpr bool is_for_systems_only = false;
template <transport::Limiter L>
inline constexpr bool is_for_systems_only<transport::PiecewiseLinearCommon<L>> = true;

/// Calls visit(reconstruction, label of its limiter) for every reconstruction of N components that the
/// library lists, with every limiter.
template <int N, class Visitor>
void for_each_reconstruction(Visitor&& visit) {
  transport::for_each_entry(transport::ReconstructionList{}, [&]<class R>() {
    if constexpr (N > 1 || !is_for_systems_only<R>) detail::Reconstructions<R>::visit_each(visit);
  });
}

/// Calls visit(reconstruction, label of its limiter) for straight lines in the primitive variables of a law,
/// kept admissible: what the library takes for such a law untold, here with every limiter.
template <class Law, class Visitor>
void for_each_reconstruction_in_primitives(const Law& law, Visitor&& visit) {
  detail::Reconstructions<transport::PiecewiseLinear<transport::Minmod>>::visit_each(
      [&](const auto& linear, const std::string& label) {
        visit(transport::Admissible{transport::InPrimitives{linear, law}, law}, label);
      });
}

}  // namespace scree::charts
