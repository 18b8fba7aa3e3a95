#pragma once

#include <scree/lattice.hpp>
#include <scree/transport/face.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <string_view>
#include <type_traits>

namespace scree::transport {

/// For people: the name in a scene, and what it is in one line.
template <class T>
concept Named = requires {
  { T::name } -> std::convertible_to<std::string_view>;
  { T::summary } -> std::convertible_to<std::string_view>;
};

/// A slope from the differences to both sides of a cell: between them, zero at an extremum.  Eq. (T5)
///
/// `sharpness()` is the largest ratio of the slope to the smaller difference: it sets the promised CFL.
template <class L>
concept Limiter = Named<L> && std::copyable<L> && requires(const L limiter, double backward, double forward) {
  { limiter(backward, forward) }
  noexcept->std::same_as<double>;
  { limiter.sharpness() }
  noexcept->std::same_as<double>;
};

/// The factor of a cell's gradient, 0 to 1, from what it may change by towards a face and what it wants to,
/// both >= 0, in a cell of a width [m]. Does not fall in `allowed`, does not rise in `wanted`.  Eq. (T33)
template <class L>
concept CellLimiter = Named<L> && std::copyable<L> &&
    requires(const L limiter, double allowed, double wanted, double width) {
  { L::keeps_bounds } -> std::convertible_to<bool>;
  { limiter(allowed, wanted, width) }
  noexcept->std::same_as<double>;
};

/// A conservation law at one point: its flux along a unit normal, and a bound of |wave speed| for every
/// state between two (the whole interval, not its ends alone, where the flux is not convex). It need not be
/// assignable, which a lambda with captures is not.  Eq. (T1)
template <class L, int D>
concept PointLaw = std::copy_constructible<L> &&
    requires(const L law, const typename L::State& u, const Vector<D>& normal) {
  requires std::same_as < typename L::State, std::array < double, static_cast<std::size_t>(L::num_components)
  >> ;
  { law.flux(u, normal) }
  noexcept->std::same_as<typename L::State>;
  { law.max_speed(u, u, normal) }
  noexcept->std::same_as<double>;
};

/// A point law with diffusion in divergence form, div grad K(u): the potential K [unit of the state x m^2/s]
/// and a bound of the eigenvalues of K'(u) between two states [m^2/s].  Eq. (T11)
template <class L>
concept Diffusive = requires(const L law, const typename L::State& u) {
  { law.potential(u) }
  noexcept->std::same_as<typename L::State>;
  { law.max_diffusivity(u, u) }
  noexcept->std::same_as<double>;
};

/// A point law that bounds its wave speeds on both sides of zero, over the whole interval between two
/// states: what makes a central-upwind flux sharper than a central one.  Eq. (T16)
template <class L, int D>
concept HasSpeedRange = requires(const L law, const typename L::State& u, const Vector<D>& normal) {
  { law.speed_range(u, u, normal) }
  noexcept->std::same_as<SpeedRange>;
};

/// A point law that knows the state behind a reflecting wall: equal to `u`, but for a velocity along the
/// normal that is turned round. A law without it has a wall that lets nothing pass.  Eq. (T8)
template <class L, int D>
concept HasMirror = requires(const L law, const typename L::State& u, const Vector<D>& normal) {
  { law.mirror(u, normal) }
  noexcept->std::same_as<typename L::State>;
};

/// A point law with states that cannot be, such as a negative pressure. (NaN must not be admissible.)
template <class L>
concept HasAdmissibleStates = requires(const L law, const typename L::State& u) {
  { law.is_admissible(u) }
  noexcept->std::same_as<bool>;
};

/// A point law with primitive variables, as many as it has conserved ones.
template <class L>
concept HasPrimitives = requires(const L law, const typename L::State& u) {
  { law.primitive(u) }
  noexcept->std::same_as<typename L::State>;
  { law.conserved(u) }
  noexcept->std::same_as<typename L::State>;
};

/// A law with a source s(u, x, t) [unit of the state / s], at a position x [m] and a time t [s].  Eq. (T1)
template <class L, int D>
concept HasSource = requires(const L law, const typename L::State& u, const Vector<D>& position,
                             double time) {
  { law.source(u, position, time) }
  noexcept->std::same_as<typename L::State>;
};

/// A law that differs from face to face: `at(face)` is the point law there. It is not asked at faces with
/// an empty side's values in use, nor at closed boundaries; what it returns beside empty sites is ignored.
template <class L>
concept FaceDependent = requires(const L law, const Face& face) {
  { law.at(face) }
  noexcept;
};

/// The law that holds at `face`; free of cost for laws that are the same everywhere.
template <class L>
[[nodiscard]] constexpr decltype(auto) law_at(const L& law, const Face& face) noexcept {
  if constexpr (FaceDependent<L>) {
    return law.at(face);
  } else {
    return (law);
  }
}

/// The same on grids of any cells: `at(face)` of a GridFace.
template <class L, int D>
concept GridFaceDependent = requires(const L law, const GridFace<D>& face) {
  { law.at(face) }
  noexcept;
};

template <int D, class L>
[[nodiscard]] constexpr decltype(auto) law_at(const L& law, const GridFace<D>& face) noexcept {
  if constexpr (GridFaceDependent<L, D>) {
    return law.at(face);
  } else {
    return (law);
  }
}

namespace detail {
/// Only for its type.
template <class L>
constexpr decltype(auto) point_law_of(const L& law) noexcept {
  if constexpr (FaceDependent<L>) {
    return law.at(Face{});
  } else if constexpr (GridFaceDependent<L, 1>) {
    return law.at(GridFace<1>{});
  } else if constexpr (GridFaceDependent<L, 2>) {
    return law.at(GridFace<2>{});
  } else if constexpr (GridFaceDependent<L, 3>) {
    return law.at(GridFace<3>{});
  } else {
    return (law);
  }
}
}  // namespace detail

/// The point law of a law: itself, or what its `at(face)` returns.
template <class L>
using PointLawOf = std::remove_cvref_t<decltype(detail::point_law_of(std::declval<const L&>()))>;

template <class L, int D>
concept ConservationLaw = std::copy_constructible<L> && PointLaw<PointLawOf<L>, D>;

/// Combines a law with the states on both sides of a face.  Eq. (T3)
template <class F, class Law, int D>
concept NumericalFlux = Named<F> && std::copyable<F> &&
    requires(const F flux, const Law law, const typename Law::State& u, const Vector<D>& normal) {
  { flux(law, u, u, normal) }
  noexcept->std::same_as<FaceFlux<typename Law::State>>;
};

/// The values at the two faces of a cell along a line, from three cells. Bounded by them, unless it says that
/// it is not.
///
/// Where a neighbour is missing or empty it is called with three equal states.
/// `promised_cfl()` is the largest CFL number at which bounds and total variation are kept, or, by one that
/// leaves bounds, no wave grows.  Eqs. (T9), (T41)
template <class R, int N>
concept Reconstruction = Named<R> && std::copyable<R> &&
    requires(const R reconstruction, const std::array<double, static_cast<std::size_t>(N)>& u) {
  { reconstruction(u, u, u) }
  noexcept->std::same_as<Edges<std::array<double, static_cast<std::size_t>(N)>>>;
  { reconstruction.promised_cfl() }
  noexcept->std::same_as<double>;
};

/// Whether a reconstruction is right for cells of equal width only.
template <class R>
constexpr bool needs_equal_cells = requires {
  requires R::needs_equal_cells;
};

/// Whether a reconstruction may leave the bounds of the three cells.
template <class R>
constexpr bool leaves_bounds = requires {
  requires R::leaves_bounds;
};

/// The flux out through a boundary face, from the state inside and the face. A closed boundary lets nothing
/// through, and no law is asked there.
template <class B, class Flux, class Law, int D>
concept Boundary = Named<B> && std::copyable<B> &&
    requires(const B boundary, const Flux flux, const Law law, const typename Law::State& inside,
             const BoundaryFace<D>& face) {
  { B::is_closed } -> std::convertible_to<bool>;
  { boundary.flux(flux, law, inside, face) }
  noexcept->std::same_as<FaceFlux<typename Law::State>>;
};

/// Control volumes in rows, columns and layers, each filled with a density of its own; no density, no site.
/// Sites are numbered with the first axis fastest; a site has one coordinate per axis, from 0 on.
/// `is_full` says that all densities are 1, `has_equal_spacing` that cells of an axis have equal extents.
///
/// `width(axis, coordinate)` is the extent of the sites with this coordinate [m], `distance_below` the
/// distance to the site below, round the end of a periodic axis, and `end` where a boundary lies [m].
/// The balance is rho_i V_i du_i/dt = -sum_f rho_f A_f F_f, rho_f = min(rho_i, rho_j).  Eqs. (T2), (T10)
template <class G>
concept LatticeGrid = std::copyable<G> &&
    requires(const G grid, int axis, Index coordinate, const Indices<G::dimension>& site) {
  { G::dimension } -> std::convertible_to<int>;
  { G::has_equal_spacing } -> std::convertible_to<bool>;
  { G::is_full } -> std::convertible_to<bool>;
  { grid.count() }
  noexcept->std::convertible_to<Indices<G::dimension>>;
  { grid.is_periodic() }
  noexcept->std::convertible_to<std::array<bool, static_cast<std::size_t>(G::dimension)>>;
  { grid.width(axis, coordinate) }
  noexcept->std::same_as<double>;
  { grid.distance_below(axis, coordinate) }
  noexcept->std::same_as<double>;
  { grid.end(axis, End::low) }
  noexcept->std::same_as<double>;
  { grid.position(site) }
  noexcept->std::convertible_to<Vector<G::dimension>>;
  { grid.density(coordinate) }
  noexcept->std::same_as<double>;
};

/// Cells of any form and number of faces, in any order: what an unstructured mesh is, and a user's own grid.
///
/// A cell's faces close: the sum of area x normal, outward, over them is zero, or no uniform state stays.
template <class G>
concept FaceGrid = std::copyable<G> && requires(const G grid, Index i, int boundary) {
  { G::dimension } -> std::convertible_to<int>;
  { grid.num_cells() }
  noexcept->std::same_as<Index>;
  { grid.num_faces() }
  noexcept->std::same_as<Index>;
  { grid.volume(i) }
  noexcept->std::same_as<double>;
  { grid.centre(i) }
  noexcept->std::convertible_to<Vector<G::dimension>>;
  { grid.face(i) }
  noexcept->std::convertible_to<GridFace<G::dimension>>;
  { grid.num_boundaries() }
  noexcept->std::same_as<int>;
  { grid.boundary_name(boundary) } -> std::convertible_to<std::string_view>;
};

/// A Runge-Kutta method as convex combinations of forward Euler steps (Shu-Osher form): stage k is
/// kept[k] u^n + (1 - kept[k]) (u^(k-1) + dt L(u^(k-1))).  Eq. (T7)
template <class I>
concept Integrator = Named<I> && requires {
  { I::kept.size() } -> std::convertible_to<std::size_t>;
  { I::kept[0] } -> std::convertible_to<double>;
};

}  // namespace scree::transport
