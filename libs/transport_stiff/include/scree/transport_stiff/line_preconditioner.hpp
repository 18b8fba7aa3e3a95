#pragma once

#include <scree/blocks.hpp>
#include <scree/transport_stiff/stiff_part.hpp>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace scree::transport {

/// Solves (1 - gamma J) z = r nearly, J the Jacobian of diffusion and source: line by line, all the lines of
/// one axis after those of the other.  Eq. (T56)
///
/// In 1D it is a direct solve. In 2D and 3D the product of the axes' factors differs from the sum by
/// gamma^2 J_x J_y: good as long as gamma J is not far above 1. Keeps 4 N^2 doubles per site and axis, and
/// N^2 more for a source. Lines run on threads.
template <LatticeGrid Grid, class Law>
class LinePreconditioner {
 public:
  static constexpr int D = Grid::dimension;
  static constexpr int N = PointLawOf<Law>::num_components;

  LinePreconditioner(const Lattice<D>& lattice, Threads threads) : lattice_{lattice}, threads_{threads} {
    const auto num_sites = static_cast<std::size_t>(lattice.num_sites());
    for (auto& rows : rows_) rows.resize(num_sites);
    if constexpr (HasSource<Law, D>) points_.resize(num_sites);
  }

  /// Factors the lines at u.
  /// @param u num_sites x N, component fastest @param gamma [s]
  void prepare(const Grid& grid, const Law& law, double time, std::span<const double> u, double gamma) {
    find_increments(u);
    if constexpr (HasSource<Law, D>) {
      for_each_site(lattice_, threads_, [&](Index site, const Indices<D>& coordinates) {
        points_[at(site)] = Block::Identity();
        if (!(grid.density(site) > 0)) return;
        const auto source = [&, x = lattice_.position(coordinates)](const State& v) {
          return law.source(v, x, time);
        };
        points_[at(site)] -= gamma * derivative(state_at<size>(u, site), source);
      });
    }
    for (int axis = 0; axis < D; ++axis) {
      auto& rows = rows_[static_cast<std::size_t>(axis)];
      for_each_site(lattice_, threads_, [&](Index site, const Indices<D>& coordinates) {
        rows[at(site)] = row(grid, law, u, gamma, site, coordinates, axis);
      });
      for_each_line(axis, [&](const Line& line) { factor(line, axis); });
    }
  }

  /// @param residual, z num_sites x N, component fastest
  void solve(std::span<const double> residual, std::span<double> z) {
    std::ranges::copy(residual, z.begin());
    for (int axis = 0; axis < D; ++axis) {
      if constexpr (HasSource<Law, D>) {
        if (axis > 0) {
          for_each_site(lattice_, threads_, [&](Index site, const Indices<D>& /*coordinates*/) {
            put(z, site, points_[at(site)] * get(z, site));
          });
        }
      }
      for_each_line(axis, [&](const Line& line) { substitute(z, line, axis); });
    }
  }

 private:
  static constexpr auto size = static_cast<std::size_t>(N);
  using State = std::array<double, size>;
  using Block = Matrix<N>;
  using Column = Vector<N>;

  /// Of (1 - gamma J) along a line. Before factoring the blocks themselves; after it the inverse of the pivot
  /// on the diagonal, and pivot^-1 above. A periodic line is bordered by its last site: `border` is what a
  /// unit there makes at this one.
  struct Row {
    Block below;
    Block diagonal;
    Block above;
    Block border;
  };

  /// The sites start, start + stride, .., last.
  struct Line {
    Index start;
    Index last;
    Index stride;
  };

  [[nodiscard]] static std::size_t at(Index site) noexcept { return static_cast<std::size_t>(site); }
  [[nodiscard]] static Column get(std::span<const double> values, Index site) noexcept {
    return Eigen::Map<const Column>(values.data() + site * N);
  }
  static void put(std::span<double> values, Index site, const Column& column) noexcept {
    Eigen::Map<Column>(values.data() + site * N) = column;
  }

  /// Calls body(line) for each line along `axis`.
  template <class Body>
  void for_each_line(int axis, Body&& body) const {
    const Index stride = lattice_.stride(axis);
    const Index count = lattice_.count[static_cast<std::size_t>(axis)];
    const Index num_lines = lattice_.num_sites() / count;
    for_each_block(num_lines, threads_, [&](Index line) {
      const Index start = line / stride * stride * count + line % stride;
      body(Line{start, start + (count - 1) * stride, stride});
    });
  }

  /// Increments of the components for derivatives: half the digits of their largest values; of a component
  /// that is zero everywhere those of 1.
  void find_increments(std::span<const double> u) {
    Column largest = Column::Zero();
    for (Index site = 0; site < lattice_.num_sites(); ++site)
      largest = largest.cwiseMax(get(u, site).cwiseAbs());
    const double half_digits = std::sqrt(std::numeric_limits<double>::epsilon());
    for (int k = 0; k < N; ++k) increments_[k] = half_digits * (largest[k] > 0 ? largest[k] : 1.0);
  }

  template <class Function>
  [[nodiscard]] Block derivative(const State& u, Function&& function) const noexcept {
    const auto here = function(u);
    Block result;
    for (int k = 0; k < N; ++k) {
      State beside = u;
      beside[static_cast<std::size_t>(k)] += increments_[k];
      const auto there = function(beside);
      for (int row = 0; row < N; ++row) {
        const auto r = static_cast<std::size_t>(row);
        result(row, k) = (there[r] - here[r]) / increments_[k];
      }
    }
    return result;
  }

  [[nodiscard]] Row row(const Grid& grid, const Law& law, std::span<const double> u, double gamma, Index site,
                        const Indices<D>& coordinates, int axis) const noexcept {
    Row result{Block::Zero(), Block::Identity(), Block::Zero(), Block::Zero()};
    if (!(grid.density(site) > 0)) return result;
    if constexpr (HasSource<Law, D>) result.diagonal = points_[at(site)];
    if constexpr (Diffusive<PointLawOf<Law>>) {
      const auto add = [&](Index neighbour, double weight, const Face& face) {
        if (neighbour == site) return;  // a period of one site
        const auto& point_law = law_at(law, face);
        const auto potential = [&](const State& v) { return point_law.potential(v); };
        result.diagonal += gamma * weight * derivative(state_at<size>(u, site), potential);
        (face.neighbour == site ? result.below : result.above) -=
            gamma * weight * derivative(state_at<size>(u, neighbour), potential);
      };
      for_each_open_face(grid, site, coordinates, axis, add);
    }
    return result;
  }

  void factor(const Line& line, int axis) noexcept {
    auto& rows = rows_[static_cast<std::size_t>(axis)];
    const Index end = last_of_chain(line, axis);
    for (Index site = line.start; site <= end; site += line.stride) {
      Row& here = rows[at(site)];
      if (end != line.last) {
        if (site == line.start) here.border += here.below;
        if (site == end) here.border += here.above;
      }
      if (site != line.start) {
        const Row& before = rows[at(site - line.stride)];
        here.diagonal -= here.below * before.above;
        here.border -= here.below * before.border;
      }
      here.diagonal = here.diagonal.inverse().eval();
      here.above = here.diagonal * here.above;
      here.border = here.diagonal * here.border;
    }
    if (end == line.last) return;
    for (Index site = end - line.stride; site >= line.start; site -= line.stride) {
      rows[at(site)].border -= rows[at(site)].above * rows[at(site + line.stride)].border;
    }
    Row& last = rows[at(line.last)];
    last.diagonal -= last.below * rows[at(end)].border + last.above * rows[at(line.start)].border;
    last.diagonal = last.diagonal.inverse().eval();
  }

  void substitute(std::span<double> z, const Line& line, int axis) const noexcept {
    const auto& rows = rows_[static_cast<std::size_t>(axis)];
    const Index end = last_of_chain(line, axis);
    for (Index site = line.start; site <= end; site += line.stride) {
      Column right = get(z, site);
      if (site != line.start) right -= rows[at(site)].below * get(z, site - line.stride);
      put(z, site, rows[at(site)].diagonal * right);
    }
    for (Index site = end - line.stride; site >= line.start; site -= line.stride) {
      put(z, site, get(z, site) - rows[at(site)].above * get(z, site + line.stride));
    }
    if (end == line.last) return;
    const Row& last = rows[at(line.last)];
    const Column right = get(z, line.last) - last.below * get(z, end) - last.above * get(z, line.start);
    const Column border = last.diagonal * right;
    put(z, line.last, border);
    for (Index site = line.start; site <= end; site += line.stride) {
      put(z, site, get(z, site) - rows[at(site)].border * border);
    }
  }

  /// The last site that couples to its neighbours only: of a periodic line the last but one.
  [[nodiscard]] Index last_of_chain(const Line& line, int axis) const noexcept {
    const bool is_bordered = lattice_.is_periodic[static_cast<std::size_t>(axis)] && line.last != line.start;
    return is_bordered ? line.last - line.stride : line.last;
  }

  Lattice<D> lattice_;
  Threads threads_;
  Column increments_ = Column::Ones();
  std::array<std::vector<Row>, static_cast<std::size_t>(D)> rows_;
  std::vector<Block> points_;  // 1 - gamma ds/du
};

}  // namespace scree::transport
