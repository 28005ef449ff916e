// What a file holds before its recording begins and after it has ended.
#include "measure/data/recorded_span.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "measure/data/missing_cells.hpp"
#include "measure/thresholds.hpp"
#include "tests/changed_thresholds.hpp"

namespace secular {
namespace {

constexpr std::size_t recorded = 4000;
constexpr double chance = 1e-6;

Channel channel_of(Quantity quantity, ChannelRole role = ChannelRole::response) {
  return {"tip", role, quantity, "m"};
}

// A motion of 31.37 samples a turn, with noise, rounded to a step (0: not).
std::vector<double> motion(double noise, double step, double phase = 0.4) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  std::vector<double> x(recorded);
  for (std::size_t i = 0; i < recorded; ++i) {
    x[i] = std::cos(2 * std::numbers::pi * static_cast<double>(i) / 31.37 + phase) + noise * normal(random);
    if (step > 0) x[i] = step * std::round(x[i] / step);
  }
  return x;
}

// The same from sample `at` on at one value.
std::vector<double> ending(std::vector<double> x, std::size_t at, double value) {
  std::fill(x.begin() + static_cast<std::ptrdiff_t>(at), x.end(), value);
  return x;
}

// Half and twice as many samples beside the end tell the same.
TEST(RecordedSpan, EndsWhereOneValueIsRepeatedThatTheMotionCannotRestAt) {
  const auto check = [](Quantity quantity, double noise, double step) {
    for (const std::size_t left : {recorded - 2, recorded - 30, recorded - 1500})
      for (const double value : {-999.0, 0.0, 32767.0}) {
        if (value == 0 && left == recorded - 2) continue;  // two equal samples: chance, in noise
        const std::vector<double> x = ending(motion(noise, step), left, value);
        const RecordedSpan span = recorded_span(x, channel_of(quantity), chance);
        EXPECT_EQ(span.begin, 0u);
        EXPECT_EQ(span.end, left) << "noise " << noise << ", step " << step << ", value " << value << ", quantity "
                                  << to_string(quantity) << ", beside it " << x[left - 1];
      }
  };
  for (const std::size_t beside : {32u, 64u, 128u}) {
    testing_support::ChangedThresholds<MeasureThresholds> thresholds;
    thresholds->local_samples = beside;
    for (const Quantity quantity : {Quantity::displacement, Quantity::velocity, Quantity::acceleration})
      for (const double noise : {1e-3, 0.05})
        for (const double step : {0.0, 1e-4, 2e-4}) check(quantity, noise, step);
  }
}

TEST(RecordedSpan, BeginsWhereAMarkEnds) {
  for (const double value : {-999.0, 1e6}) {
    std::vector<double> x = motion(1e-3, 1e-4);
    std::fill(x.begin(), x.begin() + 100, value);
    EXPECT_EQ(recorded_span(x, channel_of(Quantity::acceleration), chance).begin, 100u);
    EXPECT_EQ(recorded_span(x, channel_of(Quantity::force, ChannelRole::excitation), chance).begin, 100u);
  }
  // Rest before the motion, below a converter's step, stays.
  std::vector<double> x = motion(1e-3, 1e-4);
  std::fill(x.begin(), x.begin() + 100, 0.0);
  EXPECT_EQ(recorded_span(x, channel_of(Quantity::acceleration), chance).begin, 0u);
}

TEST(RecordedSpan, OfAFrozenDisplacementEndsWithItsLastValue) {
  const std::vector<double> whole = motion(0, 0);
  std::size_t found = 0;
  for (std::size_t at = recorded - 200; at < recorded - 200 + 31; ++at) {
    const RecordedSpan span =
        recorded_span(ending(whole, at, whole[at - 1]), channel_of(Quantity::displacement), chance);
    if (span.end == recorded) continue;  // near a turning point it may rest
    EXPECT_EQ(span.end, at - 1);
    ++found;
  }
  EXPECT_GE(found, 25u);
}

// The motions of a structure that is at rest in the end, exactly so.
TEST(RecordedSpan, HoldsRestOfTheMotion) {
  const auto is_whole = [](const std::vector<double>& x, Quantity quantity) {
    const RecordedSpan span = recorded_span(x, channel_of(quantity), chance);
    return span.begin == 0 && span.end == x.size();
  };
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (const double damping : {0.01, 0.05, 0.2})
    for (const double turn : {4.0, 9.0, 31.0, 200.0})
      for (const double step : {1e-3, 0.01, 0.1})
        for (const double noise : {0.0, 0.1, 0.3}) {  // steps
          std::vector<double> x(20000);
          for (std::size_t i = 0; i < x.size(); ++i) {
            const double t = static_cast<double>(i) / turn * 2 * std::numbers::pi;
            x[i] = step * std::round(std::exp(-damping * t) * std::cos(t) / step + noise * normal(random));
          }
          EXPECT_TRUE(is_whole(x, Quantity::displacement)) << damping << ' ' << turn << ' ' << step << ' ' << noise;
          EXPECT_TRUE(is_whole(x, Quantity::acceleration)) << damping << ' ' << turn << ' ' << step << ' ' << noise;
        }
  // Dry friction alone: x'' = -x - f sgn(x'), which sticks at a turning point; not rounded.
  for (const double f : {0.013, 0.07, 0.21})
    for (const double turn : {37.3, 50.1, 300.7}) {
      std::vector<double> x(3000), v(3000);
      double at = 1, centre = f;
      for (std::size_t i = 0; i < x.size(); ++i) {
        // Half turns about +f and -f in turn, each smaller by 2 f.
        double phase = 2 * static_cast<double>(i) / turn, half = std::floor(phase);
        at = 1, centre = f;
        bool sticks = std::abs(at) <= f;
        double sign = 1;
        for (double h = 0; h < half && !sticks; ++h) {
          at = 2 * centre - at;
          centre = -centre;
          sign = -sign;
          sticks = std::abs(at) <= f;
        }
        const double angle = std::numbers::pi * (phase - half);
        x[i] = sticks ? at : centre + (at - centre) * std::cos(angle);
        v[i] = sticks ? 0 : -(at - centre) * std::sin(angle);
      }
      EXPECT_TRUE(is_whole(x, Quantity::displacement)) << f << ' ' << turn;
      EXPECT_TRUE(is_whole(v, Quantity::velocity)) << f << ' ' << turn;
    }
}

TEST(RecordedSpan, HoldsAnExcitationThatIsSwitchedOff) {
  const Channel force = channel_of(Quantity::force, ChannelRole::excitation);
  const auto is_whole = [&](const std::vector<double>& x) {
    const RecordedSpan span = recorded_span(x, force, chance);
    return span.begin == 0 && span.end == x.size();
  };
  const std::vector<double> x = ending(motion(0, 0), 2000, 0);
  EXPECT_TRUE(is_whole(x));
  EXPECT_TRUE(is_whole(ending(motion(0.3, 1e-3), 2000, 0.3)));  // a burst that holds its last value
  std::vector<double> burst = ending(motion(1e-3, 1e-4), 2000, 0.02);
  std::fill(burst.begin(), burst.begin() + 100, 0.02);
  EXPECT_TRUE(is_whole(burst));
  std::vector<double> steps(4000, 0.0);  // of a set point; and pulses
  std::fill(steps.begin() + 1000, steps.begin() + 2000, 1.0);
  EXPECT_TRUE(is_whole(steps));
  std::fill(steps.begin() + 2000, steps.end(), 4.0);
  EXPECT_TRUE(is_whole(steps));
  EXPECT_FALSE(is_whole(ending(motion(1e-3, 0), 2000, -999)));
}

TEST(RecordedSpan, HoldsAClippedEndAndAFewLevels) {
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  std::vector<double> clipped(4000), flicker(4000, -4.0);
  for (std::size_t i = 0; i < clipped.size(); ++i) {
    const double x = std::cos(2 * std::numbers::pi * static_cast<double>(i) / 399) + 3e-3 * normal(random);
    clipped[i] = 1e-3 * std::round(1e3 * std::clamp(x, -0.8, 0.8));
    if (i < 2000) flicker[i] = static_cast<double>(random() % 2);
  }
  clipped.resize(3992);  // ends on the rail
  for (const std::vector<double>& x : {clipped, flicker}) {
    const RecordedSpan span = recorded_span(x, channel_of(Quantity::displacement), chance);
    EXPECT_EQ(span.begin, 0u);
    EXPECT_EQ(span.end, x.size());
  }
}

TEST(RecordedSpan, EndsBeforeCellsWithoutNumbers) {
  std::vector<double> x = ending(motion(1e-3, 0), 3000, std::nan(""));
  EXPECT_EQ(recorded_span(x, channel_of(Quantity::velocity), chance).end, 3000u);
  x[3500] = 0.3;  // what comes back is no end
  std::fill(x.begin() + 3500, x.end(), 0.3);
  const RecordedSpan span = recorded_span(x, channel_of(Quantity::velocity), chance);
  EXPECT_EQ(span.begin, 0u);
  EXPECT_GE(span.end, 3500u);
  const std::vector<double> nothing(100, std::nan("")), constant(100, 2.0);
  EXPECT_EQ(recorded_span(nothing, channel_of(Quantity::velocity), chance).end, 100u);
  EXPECT_EQ(recorded_span(constant, channel_of(Quantity::velocity), chance).end, 100u);
}

TEST(RecordedSpan, ChangesWithNoFactorNorWithRounding) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const double value : {-999.0, 0.0, 0.3}) {
    std::vector<double> x = ending(motion(0.01, 1e-3), 3900, value);
    const std::size_t end = recorded_span(x, channel_of(Quantity::displacement), chance).end;
    for (double& sample : x) sample *= -1e5 * (1 + 1e-9 * uniform(random));
    EXPECT_EQ(recorded_span(x, channel_of(Quantity::displacement), chance).end, end);
  }
}

TEST(FillValues, AreOneValueThatIsOutOfAllReach) {
  for (const double value : {-9.96920996838687e36, 1e30, 2147483647.0}) {
    std::vector<double> x = motion(1e-3, 0);
    x[10] = x[2000] = x[2001] = value;
    EXPECT_EQ(drop_fill_values(x), 3u);
    EXPECT_TRUE(std::isnan(x[2000]));
    EXPECT_FALSE(std::isnan(x[2002]));
    EXPECT_EQ(drop_fill_values(x), 0u);
  }
  std::vector<double> x = motion(1e-3, 0), blow(100, 0.0);
  x[10] = 2e9, x[20] = 3e9;  // two values: spikes
  EXPECT_EQ(drop_fill_values(x), 0u);
  blow[3] = 5e9;
  EXPECT_EQ(drop_fill_values(blow), 0u);
  blow[4] = 1e-17;
  blow[3] = 1;
  EXPECT_EQ(drop_fill_values(blow), 0u);  // a blow above what rounding left
  x = motion(1e-3, 0);
  x[10] = 2147483647, x[20] = -2147483648, x[30] = 1e30;
  EXPECT_EQ(drop_fill_values(x), 3u);
}

}  // namespace
}  // namespace secular
