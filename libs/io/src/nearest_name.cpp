#include "nearest_name.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace scree::io::detail {
namespace {

/// How many letters must be added, dropped, changed or swapped with their neighbour: the distance of
/// Damerau and Levenshtein, each letter touched at most once.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> edits(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) edits[i][0] = i;
  std::iota(edits[0].begin(), edits[0].end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = edits[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      edits[i][j] = std::min({changed, edits[i - 1][j] + 1, edits[i][j - 1] + 1});
      const bool is_swap = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (is_swap) edits[i][j] = std::min(edits[i][j], edits[i - 2][j - 2] + 1);
    }
  }
  return edits[a.size()][b.size()];
}

}  // namespace

std::string_view nearest_name(std::string_view name, std::span<const std::string_view> candidates) {
  std::string_view nearest;
  std::size_t least = name.size() + 1;
  for (const std::string_view candidate : candidates) {
    const std::size_t letters = std::max(name.size(), candidate.size());
    const std::size_t edits = distance(name, candidate);
    if (3 * edits > letters + 1 || edits >= least) continue;
    nearest = candidate;
    least = edits;
  }
  return nearest;
}

}  // namespace scree::io::detail
