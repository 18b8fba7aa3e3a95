// The control volumes of a grid's nodes fill its box.
#include <scree/blocks.hpp>
#include <scree/grid.hpp>

#include <vector>

int main() {
  const scree::CartesianGrid<2> grid{{0, 0}, {0.5, 0.25}, {4, 8}, {false, true}};
  const auto nodes = grid.nodes();
  std::vector<double> volumes(static_cast<std::size_t>(nodes.num_sites()));

  scree::for_each_block(nodes.num_sites(), {2}, [&](scree::Index node) {
    volumes[static_cast<std::size_t>(node)] = nodes.volume(nodes.site(node));
  });

  return scree::ordered_sum(volumes) == grid.length(0) * grid.length(1) ? 0 : 1;
}
