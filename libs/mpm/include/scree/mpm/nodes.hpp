#pragma once

#include <scree/grid.hpp>
#include <scree/mpm/node_record.hpp>

#include <algorithm>
#include <vector>

namespace scree::mpm {

/// The nodes of a grid with one record each. Past a wall stands one layer of image nodes; a periodic axis has
/// none, its nodes repeat.
template <int D>
class Nodes {
 public:
  Nodes(const CartesianGrid<D>& grid, NodeRecord record) : grid_{grid}, record_{record} {
    Index product = 1;
    for (std::size_t axis = 0; axis < D; ++axis) {
      const Index layers = grid.is_periodic()[axis] ? 0 : num_images;
      first_[axis] = -layers;
      count_[axis] = grid.nodes().count[axis] + 2 * layers;
      stride_[axis] = product;
      product *= count_[axis];
    }
    values_.assign(static_cast<std::size_t>(product * record.size()), 0.0);
  }

  /// Layers of image nodes past a wall: enough for a support of three nodes.
  static constexpr Index num_images = 1;

  [[nodiscard]] const CartesianGrid<D>& grid() const noexcept { return grid_; }
  [[nodiscard]] const NodeRecord& record() const noexcept { return record_; }
  [[nodiscard]] Index num_nodes() const noexcept {
    return static_cast<Index>(values_.size()) / record_.size();
  }
  /// Lowest node of an axis, and how many there are, image nodes included.
  [[nodiscard]] Index first(std::size_t axis) const noexcept { return first_[axis]; }
  [[nodiscard]] Index count(std::size_t axis) const noexcept { return count_[axis]; }
  [[nodiscard]] Index stride(std::size_t axis) const noexcept { return stride_[axis]; }

  /// Number along an axis from 0, of any node; -1 if there is none. Periodic axes repeat.
  [[nodiscard]] Index place(Index node, std::size_t axis) const noexcept {
    if (grid_.is_periodic()[axis]) {
      const Index n = count_[axis];
      return (node % n + n) % n;
    }
    const Index shifted = node - first_[axis];
    return 0 <= shifted && shifted < count_[axis] ? shifted : -1;
  }

  [[nodiscard]] double* operator[](Index node) noexcept { return values_.data() + node * record_.size(); }
  [[nodiscard]] const double* operator[](Index node) const noexcept {
    return values_.data() + node * record_.size();
  }

  void clear() noexcept { std::fill(values_.begin(), values_.end(), 0.0); }

 private:
  CartesianGrid<D> grid_;
  NodeRecord record_;
  Indices<D> first_{};
  Indices<D> count_{};
  Indices<D> stride_{};
  std::vector<double> values_;
};

}  // namespace scree::mpm
