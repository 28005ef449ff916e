#include "measure/data/time_axis.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/campaign/temporary_folder.hpp"

namespace secular {
namespace {

std::vector<double> stamps(double start, double rate, std::size_t count, double rounded_to = 0) {
  std::vector<double> times;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = start + static_cast<double>(i) / rate;
    times.push_back(rounded_to > 0 ? std::round(t / rounded_to) * rounded_to : t);
  }
  return times;
}

TEST(TimeAxis, FindsTheExactRateOfExactStamps) {
  for (const double rate : {1000.0, 256.0, 610.35, 0.01, 12800.0, 1e6})
    for (const double start : {0.0, -0.01, 12.5}) {
      const TimeAxis axis = even_time_axis(stamps(start, rate, 5000), "f", {});
      EXPECT_EQ(axis.sample_rate_hz, rate);
      EXPECT_EQ(axis.start_s, start);
    }
  EXPECT_EQ(even_time_axis(stamps(0, 1 / 0.0015, 5000), "f", {}).sample_rate_hz, 1 / 0.0015);
}

TEST(TimeAxis, PrefersTheExpectedRateWhereTheStampsFollowIt) {
  const double rate = 1000.0 / 3;
  EXPECT_EQ(even_time_axis(stamps(0, rate, 1000), "f", {}, rate).sample_rate_hz, rate);
  EXPECT_EQ(even_time_axis(stamps(0, 500, 1000), "f", {}, 500.4).sample_rate_hz, 500);
}

TEST(TimeAxis, RoundedStampsKeepTheRate) {
  // Stamps printed to a fifth of the step.
  const TimeAxis axis = even_time_axis(stamps(0.25, 2000, 20000, 1e-4), "f", {});
  EXPECT_EQ(axis.sample_rate_hz, 2000);
  const TimeAxis odd = even_time_axis(stamps(0, 610.35, 20000, 1e-4), "f", {});
  EXPECT_NEAR(odd.sample_rate_hz, 610.35, 610.35 * 1e-6);
  EXPECT_NEAR(odd.start_s, 0, 1e-5);
}

TEST(TimeAxis, ARateWithinAMillionthOfAnIntegerIsThatInteger) {
  EXPECT_EQ(even_time_axis(stamps(0, 1000 * (1 + 8e-7), 120000), "f", {}).sample_rate_hz, 1000);
  const double other = 1000 * (1 + 2e-6);
  EXPECT_NEAR(even_time_axis(stamps(0, other, 120000), "f", {}).sample_rate_hz, other, 1e-9 * other);
  // Not where the integer would move a stamp by half a step.
  const double drifting = 1000 * (1 + 8e-7);
  EXPECT_NEAR(even_time_axis(stamps(0, drifting, 1250000), "f", {}).sample_rate_hz, drifting, 1e-9 * drifting);
}

TEST(TimeAxis, ScatterIsJitterWhereRoundingDoesNotExplainIt) {
  std::mt19937_64 random(3);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53 - 0.5; };
  for (const double rate : {512.0, 20000.0, 0.1})
    for (const double share : {0.01, 0.2, 0.4}) {
      std::vector<double> times = stamps(3, rate, 4000);
      for (double& t : times) t += share / rate * uniform();
      EXPECT_NEAR(even_time_axis(times, "f", {}).jitter_s * rate, share / std::sqrt(12.0), 0.03 * share);
      const double printed = 1e-5 / rate;  // many digits: still jitter
      for (double& t : times) t = std::round(t / printed) * printed;
      EXPECT_NEAR(even_time_axis(times, "f", {}).jitter_s * rate, share / std::sqrt(12.0), 0.03 * share);
    }
  EXPECT_EQ(even_time_axis(stamps(0.1, 1706.7, 20000), "f", {}).jitter_s, 0);
  EXPECT_EQ(even_time_axis(stamps(0, 610.35, 20000, 1e-4), "f", {}).jitter_s, 0);        // decimals
  EXPECT_EQ(even_time_axis(stamps(0, 610.35, 20000, 1.0 / 4096), "f", {}).jitter_s, 0);  // ticks of a clock
  std::vector<double> single = stamps(0, 610.35, 20000), digits = single;
  for (double& t : single) t = static_cast<float>(t);
  for (double& t : digits) t = std::strtod(fmt::format("{:.6g}", t).c_str(), nullptr);
  EXPECT_EQ(even_time_axis(single, "f", {}).jitter_s, 0);
  EXPECT_EQ(even_time_axis(digits, "f", {}).jitter_s, 0);
}

// Stamps that repeat, or are as uneven as their rounding makes them.
TEST(TimeAxis, StampsRoundedToMoreThanHalfAStepKeepTheRate) {
  struct Rounded {
    double rate, tick, start;
  };
  for (const Rounded& r : {Rounded{2048, 1e-3, 0}, Rounded{1706.7, 1e-3, 0.25}, Rounded{610.35, 1e-3, 0},
                           Rounded{30, 0.1, 12}, Rounded{51200, 1e-4, 0}, Rounded{25, 1, 3}}) {
    const std::vector<double> even = stamps(r.start, r.rate, 20000);
    for (const int direction : {-1, 0, 1}) {
      std::vector<double> times = even;
      for (double& t : times) {
        const double ticks = t / r.tick;
        t = r.tick * (direction == 0 ? std::round(ticks) : direction < 0 ? std::floor(ticks) : std::ceil(ticks));
      }
      const TimeAxis axis = even_time_axis(times, "f", {});
      EXPECT_NEAR(axis.sample_rate_hz, r.rate, 1e-6 * r.rate) << r.rate << ' ' << direction;
      EXPECT_NEAR(axis.start_s, r.start, 0.6 * r.tick) << r.rate << ' ' << direction;
      EXPECT_EQ(axis.jitter_s, 0) << r.rate;
      EXPECT_EQ(even_time_axis(times, "f", {}, r.rate).sample_rate_hz, r.rate);
    }
  }
}

// What is no rounding stays refused: lost samples at random, lost ones at every buffer's end, one sample too many.
TEST(TimeAxis, LostSamplesAreNoRounding) {
  std::mt19937_64 random(7);
  for (const double rate : {1000.0, 10.0}) {
    const double tick = 1 / rate;
    const std::vector<double> whole = stamps(0, rate, 20000, tick);
    const auto refused = [&](std::vector<double> times) {
      return !refusal([&] { even_time_axis(times, "f", {}, rate); }).empty() &&
             !refusal([&] { even_time_axis(times, "f", {}); }).empty();
    };
    for (const int lost : {1, 3, 40, 2000}) {
      std::vector<double> times = whole;
      for (int i = 0; i < lost; ++i)
        times.erase(times.begin() + 1 + static_cast<long>(random() % (times.size() - 2)));
      EXPECT_TRUE(refused(times)) << lost;
    }
    std::vector<double> buffers;
    for (std::size_t i = 0; i < whole.size(); ++i)
      if (i % 1024 != 1023) buffers.push_back(whole[i]);
    EXPECT_TRUE(refused(buffers));
    std::vector<double> twice = whole;
    twice.insert(twice.begin() + 5000, whole[5000]);
    EXPECT_TRUE(refused(twice));
  }
  // Too short for its ticks to tell the rate.
  EXPECT_FALSE(refusal([&] { even_time_axis(stamps(0, 700, 40, 1e-3), "f", {}); }).empty());
}

TEST(TimeAxis, EpochTimeIsAccepted) {
  EXPECT_EQ(even_time_axis(stamps(1.7e9, 1000, 10000), "f", {}).sample_rate_hz, 1000);
}

TEST(TimeAxis, RefusesUnevenTimeWithItsPlace) {
  std::vector<double> times = stamps(0, 10, 100);
  const auto complaint = [&](std::vector<double> changed) {
    return refusal([&] { even_time_axis(changed, "f.csv", {"line", 2}); });
  };
  std::vector<double> changed = times;
  changed.erase(changed.begin() + 50);
  EXPECT_TRUE(
      contains(complaint(changed), "f.csv, line 52 (t = 5.1): a gap of 0.2 s where samples are 0.1 s apart"));
  changed = times;
  changed[50] = changed[49];
  EXPECT_TRUE(contains(complaint(changed), "line 52 (t = 4.9): repeats"));
  changed = times;
  std::swap(changed[50], changed[51]);
  EXPECT_TRUE(contains(complaint(changed), "line 52"));
  changed = times;
  changed[50] += 0.04;
  EXPECT_TRUE(contains(complaint(changed), "line 52 (t = 5.04): samples are not even"));
  // A rate that changes half way has no single step out of proportion.
  changed = stamps(0, 10, 50);
  for (int i = 0; i < 50; ++i) changed.push_back(changed.back() + 0.12);
  EXPECT_TRUE(contains(complaint(changed), "samples are not even"));
  EXPECT_TRUE(contains(complaint({3}), "fewer than two samples"));
  EXPECT_TRUE(contains(complaint({-1e308, 1e308}), "out of all proportion"));
}

}  // namespace
}  // namespace secular
