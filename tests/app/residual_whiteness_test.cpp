#include "jobs/shared/residual_whiteness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace secular {
namespace {

std::vector<double> white(std::size_t n, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  std::vector<double> values(n);
  for (double& value : values) value = normal(generator);
  return values;
}

TEST(ResidualWhiteness, OfWhiteNoiseTheBandHas95Percent) {
  std::size_t lags = 0, outside = 0, alarms = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    const Whiteness found = whiteness_of(autocorrelation(white(400, seed)), 400);
    lags += found.lags;
    outside += found.outside;
    if (text_of(found).find("not white") != std::string::npos) ++alarms;
  }
  EXPECT_EQ(lags, 200u * 40);
  // Four standard deviations of a binomial law; a finite record's lags are a little too small.
  const double share = static_cast<double>(outside) / static_cast<double>(lags);
  EXPECT_NEAR(share, 0.05, 4 * std::sqrt(0.05 * 0.95 / 8000) + 0.006);
  EXPECT_LE(alarms, 2u);
}

TEST(ResidualWhiteness, ATonesAutocorrelationIsItsCosine) {
  std::vector<double> tone(400);
  for (std::size_t i = 0; i < tone.size(); ++i) tone[i] = std::sin(0.3 * static_cast<double>(i));
  const std::vector<double> found = autocorrelation(tone);
  for (std::size_t lag = 0; lag < found.size(); ++lag)
    EXPECT_NEAR(found[lag], std::cos(0.3 * static_cast<double>(lag)) * (1 - static_cast<double>(lag) / 400), 0.02);
  EXPECT_NE(text_of(whiteness_of(found, tone.size())).find("not white"), std::string::npos);
  EXPECT_TRUE(autocorrelation(std::vector<double>(100, 2.0)).empty());
}

TEST(ResidualWhiteness, ShareFittedIsOneWhereAllIsComputedAndZeroForTheMean) {
  const std::vector<double> y = {1, 2, 4, -3}, mean(4, 1);
  EXPECT_EQ(share_fitted(y, y), 1);
  EXPECT_NEAR(share_fitted(y, mean), 0, 1e-15);
}

}  // namespace
}  // namespace secular
