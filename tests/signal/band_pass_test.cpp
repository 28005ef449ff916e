// Zero-phase band-pass.
#include "measure/signal/band_pass.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

MatrixXd tone(double frequency_hz, double phase, Index samples, double rate) {
  MatrixXd x(samples, 1);
  for (Index i = 0; i < samples; ++i)
    x(i, 0) = std::cos(2 * std::numbers::pi * frequency_hz * static_cast<double>(i) / rate + phase);
  return x;
}

TEST(BandPass, LeavesWhatIsInsideAsItIsAndTakesAwayWhatIsOutside) {
  const double rate = 1000;
  const Band band{40, 80};
  const Index half = band_pass_reach(band, rate), samples = 2000;
  for (const double inside : {52.0, 60.0, 68.0}) {
    const MatrixXd x = tone(inside, 0.7, samples, rate), passed = band_pass(x, rate, band);
    ASSERT_EQ(passed.rows(), samples - 2 * half);
    // No delay: sample i of the result is sample i + half of the record. Hann's side lobes are 0.6 %.
    EXPECT_LT((passed - x.middleRows(half, passed.rows())).cwiseAbs().maxCoeff(), 0.007) << inside;
  }
  for (const double outside : {0.0, 25.0, 95.0, 300.0})
    EXPECT_LT(band_pass(tone(outside, 0.3, samples, rate), rate, band).cwiseAbs().maxCoeff(), 0.007) << outside;
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
  EXPECT_NEAR(factor, 1, 0.01);
  EXPECT_LT((passed - factor * x.middleRows(half, passed.rows())).cwiseAbs().maxCoeff(), 2e-3);
}

TEST(BandPass, ReturnsNothingOfARecordThatIsTooShort) {
  EXPECT_EQ(band_pass(tone(60, 0, 100, 1000), 1000, {55, 65}).rows(), 0);
}

}  // namespace
}  // namespace secular
