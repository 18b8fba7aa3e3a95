#include <scree/rheology/fluidity_grid.hpp>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <sstream>

namespace scree::rheology {

namespace {

constexpr Index no_unknown = -1;

[[noreturn]] void refuse(std::string_view what, Index cell, double value, std::string_view expected) {
  std::ostringstream message;
  message << "FluidityGrid: " << what << " of cell " << cell << " is " << value << ", must be " << expected;
  throw InputError{message.str()};
}

void require_length(std::string_view what, std::size_t length, Index num_cells) {
  if (static_cast<Index>(length) == num_cells) return;
  std::ostringstream message;
  message << "FluidityGrid: " << what << " has " << length << " values for " << num_cells << " cells";
  throw InputError{message.str()};
}

void require_fields(const FluidityFields& fields, const std::vector<Index>& cells, Index num_cells) {
  require_length("friction", fields.friction.size(), num_cells);
  require_length("pressure", fields.pressure.size(), num_cells);
  require_length("grain size", fields.grain_size.size(), num_cells);
  for (const Index cell : cells) {
    const auto c = static_cast<std::size_t>(cell);
    const auto is_positive = [](double x) { return x > 0 && std::isfinite(x); };
    if (!(fields.friction[c] >= 0 && std::isfinite(fields.friction[c]))) {
      refuse("friction", cell, fields.friction[c], "finite and at least 0");
    }
    if (!is_positive(fields.pressure[c])) {
      refuse("pressure", cell, fields.pressure[c], "finite and above 0 Pa");
    }
    if (!is_positive(fields.grain_size[c])) {
      refuse("grain size", cell, fields.grain_size[c], "finite and above 0 m");
    }
  }
}

}  // namespace

/// (spread + a diagonal) g = right + from_ends, lower triangle; all per square of the grain size.
template <int D>
struct FluidityGrid<D>::Equations {
  using Matrix = Eigen::SparseMatrix<double>;
  Matrix spread;
  Matrix matrix;
  Eigen::VectorXd from_ends;
  Eigen::VectorXd right;
  Eigen::SimplicialLDLT<Matrix, Eigen::Lower> solver;

  Equations(const Lattice<D>& cells, const std::vector<Index>& unknown_of, Index num_unknowns,
            const FluidityEnds<D>& ends, double strength);

  /// Starts anew, with no diagonal.
  void clear() { matrix = spread; }

  /// In a lower triangle stored by columns the diagonal comes first.
  void add(Index unknown, double diagonal, double to_right) {
    matrix.valuePtr()[matrix.outerIndexPtr()[unknown]] += diagonal;
    right[unknown] = to_right;
  }

  /// Leaves the fluidity in `right`.  @throws RunError `if_open` if the equations do not determine it.
  void solve(const char* if_open) {
    solver.factorize(matrix);
    if (solver.info() != Eigen::Success || !is_sound()) throw RunError{if_open};
    right += from_ends;
    const Eigen::VectorXd fluidity = solver.solve(right);
    right = fluidity;
  }

  /// A pivot of a singular matrix is zero up to the rounding of its diagonal, once per unknown.
  [[nodiscard]] bool is_sound() const {
    const Eigen::VectorXd diagonal = solver.permutationP() * Eigen::VectorXd{matrix.diagonal()};
    const double rounding = static_cast<double>(diagonal.size()) * round_off;
    return ((solver.vectorD() - rounding * diagonal).array() > 0).all();
  }
};

namespace {

/// Calls face(unknown, other unknown) for each open face across an axis, and end(unknown, value) where the
/// fluidity is held.
template <int D, class Face, class End>
void for_each_face(const Lattice<D>& cells, const std::vector<Index>& unknown_of, std::size_t axis,
                   const std::array<std::optional<double>, 2>& ends, Face&& face, End&& end) {
  const Index last = cells.count[axis] - 1;
  for (Index cell = 0; cell < cells.num_sites(); ++cell) {
    const Index unknown = unknown_of[static_cast<std::size_t>(cell)];
    if (unknown == no_unknown) continue;
    Indices<D> site = cells.site(cell);
    if (site[axis] == 0 && ends[0]) end(unknown, *ends[0]);
    if (site[axis] == last && ends[1]) end(unknown, *ends[1]);
    if (site[axis] == last && (!cells.is_periodic[axis] || last == 0)) continue;
    site[axis] = site[axis] == last ? 0 : site[axis] + 1;
    const Index other = unknown_of[static_cast<std::size_t>(cells.index(site))];
    if (other != no_unknown) face(unknown, other);
  }
}

template <int D>
void require_ends(const Lattice<D>& cells, const FluidityEnds<D>& ends) {
  for (std::size_t axis = 0; axis < D; ++axis) {
    for (const auto& held : ends[axis]) {
      if (!held) continue;
      require(*held >= 0 && std::isfinite(*held),
              "FluidityGrid: a fluidity that is held must be finite and at least 0");
      require(!cells.is_periodic[axis], "FluidityGrid: a periodic axis has no end to hold the fluidity at");
    }
  }
}

}  // namespace

/// @param strength A^2 times the volume of a cell
template <int D>
FluidityGrid<D>::Equations::Equations(const Lattice<D>& cells, const std::vector<Index>& unknown_of,
                                      Index num_unknowns, const FluidityEnds<D>& ends, double strength)
    : spread{num_unknowns, num_unknowns},
      from_ends{Eigen::VectorXd::Zero(num_unknowns)},
      right{Eigen::VectorXd::Zero(num_unknowns)} {
  std::vector<Eigen::Triplet<double>> entries;
  const auto add_entry = [&](Index row, Index column, double value) {
    entries.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
  };
  for (Index unknown = 0; unknown < num_unknowns; ++unknown) add_entry(unknown, unknown, 0);
  for (std::size_t axis = 0; axis < D; ++axis) {
    const double h = cells.spacing[static_cast<int>(axis)];
    const double through = strength / (h * h);
    for_each_face(
        cells, unknown_of, axis, ends[axis],
        [&](Index one, Index other) {
          add_entry(one, one, through);
          add_entry(other, other, through);
          add_entry(std::max(one, other), std::min(one, other), -through);
        },
        [&](Index one, double held) {  // half a cell away
          add_entry(one, one, 2 * through);
          from_ends[one] += 2 * through * held;
        });
  }
  spread.setFromTriplets(entries.begin(), entries.end());
  solver.analyzePattern(spread);
}

template <int D>
FluidityGrid<D>::FluidityGrid(const NonlocalFluidity& model, const Lattice<D>& cells,
                              const std::vector<bool>& is_occupied, const FluidityEnds<D>& ends)
    : model_{model}, num_cells_{cells.num_sites()}, volume_{cells.spacing.prod()} {
  validate(model);
  require(cells.sites == Sites::cells, "FluidityGrid: the lattice must be that of cells");
  require_length("occupation", is_occupied.size(), num_cells_);
  require_ends(cells, ends);
  std::vector<Index> unknown_of(is_occupied.size(), no_unknown);
  for (std::size_t cell = 0; cell < is_occupied.size(); ++cell) {
    if (!is_occupied[cell]) continue;
    unknown_of[cell] = static_cast<Index>(cells_.size());
    cells_.push_back(static_cast<Index>(cell));
  }
  require(!cells_.empty(), "FluidityGrid: no cell holds material");
  equations_ = std::make_unique<Equations>(cells, unknown_of, static_cast<Index>(cells_.size()), ends,
                                           model.amplitude * model.amplitude * volume_);
}

template <int D>
FluidityGrid<D>::FluidityGrid(FluidityGrid&&) noexcept = default;
template <int D>
FluidityGrid<D>& FluidityGrid<D>::operator=(FluidityGrid&&) noexcept = default;
template <int D>
FluidityGrid<D>::~FluidityGrid() = default;

template <int D>
void FluidityGrid<D>::solve_steady(const FluidityFields& fields, std::span<double> fluidity) {
  require_fields(fields, cells_, num_cells_);
  require_length("fluidity", fluidity.size(), num_cells_);
  equations_->clear();
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const auto c = static_cast<std::size_t>(cells_[i]);
    const double size = fields.grain_size[c];
    const double pull = volume_ * std::abs(fields.friction[c] - model_.mu_s) / (size * size);
    equations_->add(static_cast<Index>(i), pull,
                    pull * model_.local_fluidity(fields.friction[c], fields.pressure[c], size));
  }
  equations_->solve(
      "FluidityGrid: where the friction is mu_s all over and no end is held, the steady "
      "fluidity is left open");
  write_to(fluidity);
}

template <int D>
void FluidityGrid<D>::step(const FluidityFields& fields, double dt, std::span<double> fluidity) {
  require_fields(fields, cells_, num_cells_);
  require_length("fluidity", fluidity.size(), num_cells_);
  require(dt > 0 && std::isfinite(dt), "FluidityGrid: a step must be finite and above 0 s");
  equations_->clear();
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const auto c = static_cast<std::size_t>(cells_[i]);
    const double g = fluidity[c];
    if (!(g >= 0 && std::isfinite(g))) refuse("fluidity", cells_[i], g, "finite and at least 0 1/s");
    const double size = fields.grain_size[c];
    const double weight = volume_ / (size * size);
    const double inertia = model_.response_time / dt;
    const double excess = fields.friction[c] - model_.mu_s;
    const double loss =
        std::max(-excess, 0.0) + model_.saturation(fields.friction[c], fields.pressure[c], size) * g;
    equations_->add(static_cast<Index>(i), weight * (inertia + loss),
                    weight * (inertia + std::max(excess, 0.0)) * g);
  }
  equations_->solve(
      "FluidityGrid: the step is too long beside the response time for the fluidity to be "
      "told from what spreads");
  write_to(fluidity);
}

template <int D>
void FluidityGrid<D>::write_to(std::span<double> fluidity) const {
  std::fill(fluidity.begin(), fluidity.end(), 0.0);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    fluidity[static_cast<std::size_t>(cells_[i])] = equations_->right[static_cast<Index>(i)];
  }
}

template class FluidityGrid<1>;
template class FluidityGrid<2>;
template class FluidityGrid<3>;

}  // namespace scree::rheology
