#pragma once

#include <scree/aligned.hpp>
#include <scree/grid.hpp>
#include <scree/mpm/node_record.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace scree::mpm {

/// Which end of an axis.
enum class Side { low, high };

/// Nodes that follow each other in the numbering.
struct NodeRun {
  Index begin = 0;
  Index end = 0;  ///< one past the last
};

/// The nodes of a grid with one record each. Past a wall stands one layer of image nodes; a periodic axis has
/// none, its nodes repeat. Only those in use cost time: at first all are.
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
    runs_ = {{0, product}};
    find_batches();
    find_images();
  }

  /// Takes into use the nodes of boxes and, beside nodes on walls, their images; clears all others for good.
  /// @param corners lowest node of each box  @param edge nodes of a box along each axis
  void use(std::span<const Indices<D>> corners, Index edge);

  /// Layers of image nodes past a wall: enough for a support of four nodes.
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

  /// Gives every node a record of a mass and `count` means beside its own, for what points carry.  Eq. (M170)
  void carry(Index count) {
    carried_size_ = count + 1;
    carried_.assign(static_cast<std::size_t>(num_nodes() * carried_size_), 0.0);
  }
  /// The mass that the means of a node are weighted by [kg], and they themselves.
  [[nodiscard]] double* carried(Index node) noexcept { return carried_.data() + node * carried_size_; }
  /// The means alone; null if no node has any.
  [[nodiscard]] const double* means(Index node) const noexcept {
    return carried_size_ == 0 ? nullptr : carried_.data() + node * carried_size_ + 1;
  }

  /// The nodes in use, ascending, in batches of about as much work each.
  [[nodiscard]] Index num_batches() const noexcept { return static_cast<Index>(batches_.size()) - 1; }
  [[nodiscard]] std::span<const NodeRun> batch(Index number) const noexcept {
    const auto n = static_cast<std::size_t>(number);
    return std::span{runs_}.subspan(batches_[n], batches_[n + 1] - batches_[n]);
  }

  /// The outermost nodes in use at an end of an axis, ascending: images, if it is a wall.
  [[nodiscard]] std::span<const Index> images(std::size_t axis, Side side) const noexcept {
    return images_[axis][static_cast<std::size_t>(side)];
  }

  /// Sets all to zero.
  void clear() noexcept {
    for (const NodeRun& run : runs_) std::fill((*this)[run.begin], (*this)[run.end], 0.0);
  }

 private:
  void find_batches();
  void find_images();

  CartesianGrid<D> grid_;
  NodeRecord record_;
  Indices<D> first_{};
  Indices<D> count_{};
  Indices<D> stride_{};
  AlignedVector<double> values_;
  Index carried_size_ = 0;  ///< of a record
  std::vector<double> carried_;
  std::vector<NodeRun> runs_;
  std::vector<std::size_t> batches_;  ///< the first run of each, and one past the last
  std::array<std::array<std::vector<Index>, 2>, static_cast<std::size_t>(D)> images_;
};

}  // namespace scree::mpm
