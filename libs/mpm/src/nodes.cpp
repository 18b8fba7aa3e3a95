#include <scree/mpm/nodes.hpp>

#include <algorithm>
#include <numeric>
#include <string>

namespace scree::mpm {

namespace {

/// The places from node `low` on along an axis, in one piece or, round a periodic axis, two; if the node on a
/// wall is among them, with its image.
template <int D>
[[nodiscard]] std::vector<NodeRun> places_from(const Nodes<D>& nodes, Index low, Index edge,
                                               std::size_t axis) {
  const Index count = nodes.count(axis);
  if (nodes.grid().is_periodic()[axis]) {
    if (edge >= count) return {{0, count}};
    const Index begin = nodes.place(low, axis);
    const Index end = begin + edge;
    if (end <= count) return {{begin, end}};
    return {{0, end - count}, {begin, count}};
  }
  constexpr Index images = Nodes<D>::num_images;
  Index begin = std::max(low - nodes.first(axis), Index{0});
  Index end = std::min(low - nodes.first(axis) + edge, count);
  if (begin <= images) begin = 0;
  if (end >= count - images) end = count;
  return {{begin, end}};
}

/// Appends the runs of a box of nodes.
template <int D>
void append_box(const Nodes<D>& nodes, const Indices<D>& corner, Index edge, std::vector<NodeRun>& runs) {
  std::vector<Index> starts{0};
  for (std::size_t axis = D - 1; axis > 0; --axis) {
    std::vector<Index> next;
    for (const NodeRun& places : places_from(nodes, corner[axis], edge, axis)) {
      for (Index place = places.begin; place < places.end; ++place) {
        for (const Index start : starts) next.push_back(start + place * nodes.stride(axis));
      }
    }
    starts.swap(next);
  }
  for (const NodeRun& places : places_from(nodes, corner[0], edge, 0)) {
    for (const Index start : starts) runs.push_back({start + places.begin, start + places.end});
  }
}

/// Appends begin, begin + 1, .. end - 1.
void append_range(Index begin, Index end, std::vector<Index>& numbers) {
  const std::size_t before = numbers.size();
  numbers.resize(before + static_cast<std::size_t>(end - begin));
  std::iota(numbers.begin() + static_cast<std::ptrdiff_t>(before), numbers.end(), begin);
}

}  // namespace

template <int D>
void Nodes<D>::use(std::span<const Indices<D>> corners, Index edge) {
  clear();
  std::vector<NodeRun> pieces;
  for (const Indices<D>& corner : corners) append_box(*this, corner, edge, pieces);
  constexpr char in_use = 1;
  std::string marks(static_cast<std::size_t>(num_nodes()), 0);  // a string is searched fast
  for (const NodeRun& piece : pieces)
    std::fill_n(marks.begin() + piece.begin, piece.end - piece.begin, in_use);
  runs_.clear();
  for (std::size_t begin = marks.find(in_use); begin < marks.size();) {
    const std::size_t end = std::min(marks.find('\0', begin), marks.size());
    runs_.push_back({static_cast<Index>(begin), static_cast<Index>(end)});
    begin = marks.find(in_use, end);
  }
  find_batches();
  find_images();
}

template <int D>
void Nodes<D>::find_batches() {
  constexpr Index nodes_per_batch = 4096;
  std::vector<NodeRun> parts;
  batches_.assign(1, 0);
  Index in_batch = 0;
  for (NodeRun run : runs_) {
    while (run.begin < run.end) {
      const Index end = std::min(run.end, run.begin + nodes_per_batch - in_batch);
      parts.push_back({run.begin, end});
      in_batch += end - run.begin;
      run.begin = end;
      if (in_batch < nodes_per_batch) continue;
      batches_.push_back(parts.size());
      in_batch = 0;
    }
  }
  if (in_batch > 0) batches_.push_back(parts.size());
  runs_.swap(parts);
}

template <int D>
void Nodes<D>::find_images() {
  for (auto& of_axis : images_) {
    for (auto& images : of_axis) images.clear();
  }
  for (const NodeRun& run : runs_) {
    Index end = run.begin;
    for (Index begin = run.begin; begin < run.end; begin = end) {  // row by row
      end = std::min(run.end, (begin / count_[0] + 1) * count_[0]);
      if (begin % count_[0] == 0) images_[0][0].push_back(begin);
      if (end % count_[0] == 0) images_[0][1].push_back(end - 1);
      for (std::size_t axis = 1; axis < D; ++axis) {
        const Index place = begin / stride_[axis] % count_[axis];
        if (place == 0) append_range(begin, end, images_[axis][0]);
        if (place == count_[axis] - 1) append_range(begin, end, images_[axis][1]);
      }
    }
  }
}

template class Nodes<1>;
template class Nodes<2>;
template class Nodes<3>;

}  // namespace scree::mpm
