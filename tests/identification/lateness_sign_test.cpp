// Which of two minima half a period apart is the right one, from delays whose truth is known.
#include "estimator/identification/lateness_sign.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "numerics/distribution.hpp"

namespace secular {
namespace {

constexpr double drive_period = 0.05, frequency = 2 * std::numbers::pi / drive_period;

class Delays {
 public:
  explicit Delays(std::uint64_t seed) : random_(seed) {}
  std::vector<double> between(double least, double most, std::size_t records) {
    std::vector<double> late;
    for (std::size_t r = 0; r < records; ++r)
      late.push_back(least + (most - least) * static_cast<double>(random_() >> 11) * 0x1p-53);
    return late;
  }

 private:
  std::mt19937_64 random_;
};

// The right minimum and the one half a period from it, as angles tell them.
std::vector<LatenessOfRecords> both(const std::vector<double>& late) {
  std::vector<double> right, other;
  for (const double l : late) {
    right.push_back(-frequency * l);
    other.push_back(right.back() + std::numbers::pi);
  }
  const std::vector<double> same(late.size(), frequency);
  return {lateness_of_records(right, same), lateness_of_records(other, same)};
}

TEST(LatenessSign, AnglesAreBroughtNearToTheirCommonDirection) {
  const std::vector<double> late = {0.018, 0.022, 0.027, 0.031};
  const LatenessOfRecords found = both(late).front();
  EXPECT_NEAR(found.period_s, drive_period, 1e-12);
  for (std::size_t r = 0; r < late.size(); ++r)
    EXPECT_NEAR(found.late_s[r] - found.late_s[0], late[r] - late[0], 1e-12) << r;
}

// Delays up to every share of a period: it may stay open, and is wrong no more often than its alarm level of 0.5 %
// says (a count above the bound comes once in ten thousand).
TEST(LatenessSign, OfDelaysByLotIsTellingOrOpen) {
  constexpr double draws = 400;
  for (const double share : {0.05, 0.2, 0.3, 0.45, 0.6, 0.8, 1.0, 1.7}) {
    double right = 0, wrong = 0;
    for (std::uint64_t draw = 1; draw <= static_cast<std::uint64_t>(draws); ++draw) {
      const auto told = told_by_own_lateness(both(Delays(draw).between(0, share * drive_period, 12)));
      right += told == 0U;
      wrong += told == 1U;
    }
    EXPECT_GT(binomial_upper_tail(wrong, draws, 0.005), 1e-4) << share << ": " << wrong << " wrong";
    if (share < 0.25) {
      EXPECT_GT(right, 0.9 * draws) << share;
    }
  }
}

// A delay that all share, small against the period or not.
TEST(LatenessSign, OfACommonDelayIsToldIfItIsSmall) {
  Delays delays(5);
  EXPECT_EQ(told_by_own_lateness(both(delays.between(0.001, 0.0011, 12))), 0U);
  EXPECT_EQ(told_by_own_lateness(both(delays.between(-0.0011, -0.001, 12))), 0U);
  for (const double delay : {0.005, 0.012, 0.02})
    EXPECT_FALSE(told_by_own_lateness(both(delays.between(delay, delay + 1e-4, 12)))) << delay;
}

// Frequencies about a resonance: half their periods differ, one delay does not. Phases are known to a hundredth.
TEST(LatenessSign, OfACommonDelayIsToldByDifferentPeriods) {
  std::mt19937_64 random(4);
  for (const double delay : {0.012, 0.0245, 0.026, 0.033, -0.024})
    for (const double width : {0.02, 0.1}) {
      std::vector<double> right, other, frequencies;
      for (int r = 0; r < 16; ++r) {
        frequencies.push_back(frequency * (1 + width * (r - 7.5) / 16));
        const double noise = 0.002 * (static_cast<double>(random() >> 11) * 0x1p-53 - 0.5);
        right.push_back(-frequencies.back() * delay + noise);
        other.push_back(right.back() + std::numbers::pi);
      }
      const std::vector<LatenessOfRecords> minima = {lateness_of_records(other, frequencies),
                                                     lateness_of_records(right, frequencies)};
      EXPECT_EQ(told_by_own_lateness(minima), 1U) << delay << ' ' << width;
    }
}

// Records of a slower case have told how late the recorder is.
TEST(LatenessSign, IsToldByOtherCasesOfTheCampaign) {
  double wrong = 0, right = 0;
  for (std::uint64_t draw = 1; draw <= 50; ++draw) {
    Delays delays(draw);
    const std::vector<LatenessOfRecords> minima = both(delays.between(0, 0.02, 12));
    const auto told = told_by_other_lateness(minima, delays.between(0, 0.02, 12));
    wrong += told == 1U;
    right += told == 0U;
    EXPECT_FALSE(told_by_other_lateness(minima, {})) << draw;
    // Of another recorder, half way between both.
    EXPECT_FALSE(told_by_other_lateness(minima, delays.between(0.0224, 0.0226, 12))) << draw;
  }
  EXPECT_GT(binomial_upper_tail(wrong, 50, 0.005), 1e-4);
  EXPECT_GT(right, 45);
}

}  // namespace
}  // namespace secular
