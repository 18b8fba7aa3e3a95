#pragma once

#include <scree/error.hpp>
#include <scree/mpm/column.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scree::mpm {

/// The material points of a run as columns of one length, sorted together.
///
/// D dimensions of space and V >= D components of velocity: a plane-parallel flow is a column with D = 1 and
/// V = 2. Component d < D of a velocity points along axis d; the others have no axis. Points of mass zero
/// only fill blocks up to whole packs: they follow a real neighbour and weigh nothing.
template <int D, int V = D>
class Particles {
 public:
  static_assert(1 <= D && D <= V && V <= 3);

  Column position{{"position", "x", "m"}, D};
  Column velocity{{"velocity", "v", "m/s"}, V};
  /// dv_i/dx_j is component i + V j; the affine part of the velocity in APIC is the same tensor.
  Column velocity_gradient{{"velocity_gradient", "L", "1/s"}, V* D};
  Column stress{{"stress", "sigma", "Pa"}, V* D};  ///< sigma_ij for j < D, component i + V j
  Column mass{{"mass", "m", "kg"}, 1};
  Column density{{"density", "rho", "kg/m^3"}, 1};
  Column id{{"id", "id", "-"}, 1};  ///< whole numbers; a point keeps its own when points are sorted

  /// Number of stored points, those of mass zero among them.
  [[nodiscard]] Index size() const noexcept { return mass.size(); }

  /// Gives every column `size` points, all zero.
  void resize(Index size) {
    for_each_column([&](Column& column) { column.resize(size); });
  }

  /// Adds a column that some part of the run needs, all zero; a second request for the same name is the same
  /// column. @returns its index.  @throws InputError if the name is taken by a column of another shape.
  std::size_t add_column(const Quantity& quantity, int num_components) {
    for (std::size_t i = 0; i < extras_.size(); ++i) {
      if (extras_[i].quantity().name != quantity.name) continue;
      require(extras_[i].num_components() == num_components && extras_[i].quantity() == quantity,
              "Particles: two different columns are named '" + quantity.name + "'");
      return i;
    }
    extras_.emplace_back(quantity, num_components);
    extras_.back().resize(size());
    return extras_.size() - 1;
  }

  /// Index of an added column, if there is one of that name.
  [[nodiscard]] std::optional<std::size_t> column_named(std::string_view name) const {
    for (std::size_t i = 0; i < extras_.size(); ++i) {
      if (extras_[i].quantity().name == name) return i;
    }
    return std::nullopt;
  }

  /// Index of an added column.  @throws InputError naming `wanted_by` if there is none of that name.
  [[nodiscard]] std::size_t find_column(std::string_view name, std::string_view wanted_by) const {
    if (const auto index = column_named(name)) return *index;
    throw InputError{std::string{wanted_by} + " needs the column '" + std::string{name} +
                     "', which no part of this run provides"};
  }

  [[nodiscard]] Column& column(std::size_t index) noexcept { return extras_[index]; }
  [[nodiscard]] const Column& column(std::size_t index) const noexcept { return extras_[index]; }

  /// Calls visit(Column&) for every column, in a fixed order.
  template <class Visit>
  void for_each_column(Visit&& visit) {
    for (Column* column : {&position, &velocity, &velocity_gradient, &stress, &mass, &density, &id}) {
      visit(*column);
    }
    for (Column& column : extras_) visit(column);
  }
  template <class Visit>
  void for_each_column(Visit&& visit) const {
    const_cast<Particles*>(this)->for_each_column([&](const Column& column) { visit(column); });
  }

  /// Memory that all columns hold, in use or not [bytes].
  [[nodiscard]] std::size_t held_bytes() const {
    std::size_t held = 0;
    for_each_column([&](const Column& column) { held += column.held_bytes(); });
    return held;
  }

  /// Memory of one point, all columns together [bytes].
  [[nodiscard]] std::size_t bytes_per_particle() const {
    std::size_t components = 0;
    for_each_column(
        [&](const Column& column) { components += static_cast<std::size_t>(column.num_components()); });
    return components * sizeof(double);
  }

 private:
  std::vector<Column> extras_;
};

}  // namespace scree::mpm
