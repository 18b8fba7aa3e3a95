#pragma once

#include <scree/error.hpp>
#include <scree/tensor.hpp>

#include <algorithm>
#include <span>

namespace scree::mpm {

/// What a site takes and gives in the exchange map.  Eq. (M22)
///
/// @param old_fractions,new_fractions of the site, one per class, each set summing to one [-]
/// @param loss_ratio what share of each class the points round the site give up, in [0, 1]; zero for a class
///        that is not there
/// @param gain_share how what they gave up is shared out over the classes; sums to one, or is zero if nothing
///        changes
inline void exchange_at_site(std::span<const double> old_fractions, std::span<const double> new_fractions,
                             std::span<double> loss_ratio, std::span<double> gain_share) noexcept {
  double total_gain = 0;
  for (std::size_t k = 0; k < old_fractions.size(); ++k) {
    const double change = new_fractions[k] - old_fractions[k];
    const bool loses = change < 0 && old_fractions[k] > 0;
    const double ratio = loses ? -change / old_fractions[k] : 0;
    SCREE_ASSERT(ratio <= 1 + 1e3 * round_off);  // who changes them keeps them above -1e3 round-offs
    loss_ratio[k] = std::min(ratio, 1.0);
    gain_share[k] = std::max(change, 0.0);
    total_gain += gain_share[k];
  }
  if (total_gain > 0) {
    for (double& share : gain_share) share /= total_gain;
  }
}

}  // namespace scree::mpm
