// Zero-phase band-pass.
#include "measure/signal/band_pass.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

MatrixXd band_tone(double frequency_hz, double phase, Index samples, double rate) {
  MatrixXd x(samples, 1);
  for (Index i = 0; i < samples; ++i)
    x(i, 0) = std::cos(2 * std::numbers::pi * frequency_hz * static_cast<double>(i) / rate + phase);
  return x;
}

TEST(BandPass, LeavesWhatIsInsideAsItIsAndTakesAwayWhatIsOutside) {
  const double rate = 1000;
  const Band band{40, 80};
  const Index half = band_pass_reach(band, rate), samples = 2000;
  for (const double inside : {40.0, 52.0, 60.0, 68.0, 80.0}) {
    const MatrixXd x = band_tone(inside, 0.7, samples, rate), passed = band_pass(x, rate, band);
    ASSERT_EQ(passed.rows(), samples - 2 * half);
    // No delay: sample i of the result is sample i + half of the record.
    EXPECT_LT((passed - x.middleRows(half, passed.rows())).cwiseAbs().maxCoeff(), 3e-4) << inside;
  }
  for (const double outside : {0.0, 120.0, 300.0})
    EXPECT_LT(band_pass(band_tone(outside, 0.3, samples, rate), rate, band).cwiseAbs().maxCoeff(), 3e-4) << outside;
}

TEST(BandPass, OfABandFromZeroOnIsALowPassAndOfOneUpToHalfTheRateAHighPass) {
  const double rate = 1000;
  const auto left = [&](double frequency, const Band& band) {  // of one
    const MatrixXd x = band_tone(frequency, 0.3, 2000, rate), passed = band_pass(x, rate, band);
    return passed.cwiseAbs().maxCoeff() /
           x.middleRows(band_pass_reach(band, rate), passed.rows()).cwiseAbs().maxCoeff();
  };
  EXPECT_NEAR(left(0, {0, 20}), 1, 3e-4);
  EXPECT_NEAR(left(20, {0, 20}), 1, 3e-4);
  EXPECT_LT(left(40, {0, 20}), 3e-4);
  EXPECT_LT(left(0, {100, 490}), 3e-4);
  EXPECT_NEAR(left(490, {100, 490}), 1, 3e-4);
}

TEST(BandPass, KnowsItsShareOfWhiteNoise) {
  std::mt19937_64 generator(5);
  std::normal_distribution<double> normal;
  MatrixXd noise(200000, 1);
  for (Index i = 0; i < noise.rows(); ++i) noise(i, 0) = normal(generator);
  for (const Band& band : {Band{40, 80}, Band{0, 100}, Band{150, 200}}) {
    const MatrixXd passed = band_pass(noise, 1000, band);
    const double share = band_share_of_noise(band, 1000);
    EXPECT_NEAR(passed.squaredNorm() / static_cast<double>(passed.rows()) / share, 1, 0.05);
    EXPECT_GT(share, (band.high_hz - band.low_hz) / 500);
  }
}

TEST(BandPass, KeepsAFreeDecaysRateAndFrequency) {
  const double rate = 1000, w = 2 * std::numbers::pi * 60, decay = 1.5;
  MatrixXd x(3000, 1);
  for (Index i = 0; i < x.rows(); ++i) {
    const double t = static_cast<double>(i) / rate;
    x(i, 0) = std::exp(-decay * t) * std::cos(w * t);
  }
  const Band band{45, 75};
  const Index half = band_pass_reach(band, rate);
  const MatrixXd passed = band_pass(x, rate, band);
  // An exponential is a tone at a complex frequency: it passes with one factor throughout.
  const double factor = passed(0, 0) / x(half, 0);
  EXPECT_NEAR(factor, 1, 1e-3);
  EXPECT_LT((passed - factor * x.middleRows(half, passed.rows())).cwiseAbs().maxCoeff(), 2e-3);
}

TEST(BandPass, ReturnsNothingOfARecordThatIsTooShort) {
  EXPECT_EQ(band_pass(band_tone(60, 0, 100, 1000), 1000, {55, 65}).rows(), 0);
}

}  // namespace
}  // namespace secular
