#include <scree/mpm/exchange_map.hpp>

#include <gtest/gtest.h>

#include <array>
#include <numeric>

namespace scree::mpm {
namespace {

using Three = std::array<double, 3>;

struct Site {
  Three loss_ratio{};
  Three gain_share{};
  Site(const Three& before, const Three& after) { exchange_at_site(before, after, loss_ratio, gain_share); }
};

TEST(ExchangeMap, TakesTheShareOfAClassThatTheSiteLoses) {  // Eq. (M22)
  const Site site{{0.5, 0.25, 0.25}, {0.25, 0.5, 0.25}};

  EXPECT_EQ(site.loss_ratio, (Three{0.5, 0, 0}));
  EXPECT_EQ(site.gain_share, (Three{0, 1, 0}));
}

TEST(ExchangeMap, SharesWhatIsGivenUpAsTheSiteGains) {
  const Site site{{1, 0, 0}, {0.25, 0.5, 0.25}};

  EXPECT_EQ(site.loss_ratio, (Three{0.75, 0, 0}));
  EXPECT_EQ(site.gain_share, (Three{0, 0.5 / 0.75, 0.25 / 0.75}));
}

TEST(ExchangeMap, GivesBackAtTheSiteWhatTheSiteHasChangedBy) {
  const Three before{0.2, 0.3, 0.5};
  const Three after{0.1, 0.7, 0.2};

  const Site site{before, after};

  double given_up = 0;
  for (std::size_t k = 0; k < 3; ++k) given_up += before[k] * site.loss_ratio[k];
  for (std::size_t k = 0; k < 3; ++k) {
    const double change = site.gain_share[k] * given_up - before[k] * site.loss_ratio[k];
    EXPECT_NEAR(change, after[k] - before[k], 10 * round_off);  // ten operations on numbers below one
  }
}

TEST(ExchangeMap, TakesNothingFromAClassThatIsNotThere) {  // a rounding below zero must not divide by zero
  const Site site{{0, 0.5, 0.5}, {-1e-17, 0.5, 0.5}};

  EXPECT_EQ(site.loss_ratio, (Three{0, 0, 0}));
  EXPECT_EQ(site.gain_share, (Three{0, 0, 0}));
}

TEST(ExchangeMap, TakesNoMoreThanThereIs) {
  const Site site{{0.5, 0.5, 0}, {-1e-16, 1, 0}};

  EXPECT_EQ(site.loss_ratio[0], 1);
}

TEST(ExchangeMap, DoesNothingWhereNothingChanges) {
  const Site site{{0.2, 0.3, 0.5}, {0.2, 0.3, 0.5}};

  EXPECT_EQ(site.loss_ratio, (Three{0, 0, 0}));
  EXPECT_EQ(site.gain_share, (Three{0, 0, 0}));
}

}  // namespace
}  // namespace scree::mpm
