#include "report/axis_ticks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace secular::report {
namespace {

std::vector<std::string> labels(const AxisTicks& axis) {
  std::vector<std::string> texts;
  for (const Tick& tick : axis.ticks)
    if (!tick.label.empty()) texts.push_back(tick.label);
  return texts;
}

TEST(AxisTicks, LinearStepsAreRoundNumbers) {
  EXPECT_EQ(labels(linear_ticks(24.16, 25.24, 8)),
            (std::vector<std::string>{"24.2", "24.4", "24.6", "24.8", "25.0", "25.2"}));
  EXPECT_EQ(labels(linear_ticks(-1, 1, 4)), (std::vector<std::string>{"−1.0", "−0.5", "0.0", "0.5", "1.0"}));
}

TEST(AxisTicks, SmallNumbersShareAPowerOfTen) {
  const AxisTicks axis = linear_ticks(0, 2.2e-3, 4);
  EXPECT_EQ(axis.power_of_ten, -3);
  EXPECT_EQ(labels(axis), (std::vector<std::string>{"0", "1", "2"}));
}

TEST(AxisTicks, LabelTimesPowerIsThePosition) {
  for (const double scale : {1e-9, 1e-4, 0.3, 7.0, 1e5, 3e11}) {
    const AxisTicks axis = linear_ticks(-0.4 * scale, 1.3 * scale, 6);
    ASSERT_GE(axis.ticks.size(), 3u) << scale;
    for (const Tick& tick : axis.ticks) {
      std::string ascii = tick.label;
      if (ascii.starts_with("−")) ascii.replace(0, std::string("−").size(), "-");
      EXPECT_NEAR(std::stod(ascii) * std::pow(10.0, axis.power_of_ten), tick.position, 1e-9 * scale);
    }
  }
}

TEST(AxisTicks, TicksStayInsideTheRange) {
  for (const auto& [low, high] : {std::pair{0.37, 0.371}, std::pair{1e4, 1.7e4}, std::pair{-3.3e-5, -3.2e-5}})
    for (const Tick& tick : linear_ticks(low, high, 7).ticks) {
      EXPECT_GE(tick.position, low - 1e-9 * (high - low));
      EXPECT_LE(tick.position, high + 1e-9 * (high - low));
    }
}

TEST(AxisTicks, DecadesAreLabelledAndSubdivided) {
  const AxisTicks axis = logarithmic_ticks(0.05, 150, 8);
  EXPECT_EQ(labels(axis), (std::vector<std::string>{"0.1", "1", "10", "100"}));
  const auto is_at = [](double position) {
    return [position](const Tick& tick) { return std::abs(tick.position / position - 1) < 1e-12; };
  };
  for (const double minor : {0.06, 0.2, 90.0})
    EXPECT_TRUE(std::any_of(axis.ticks.begin(), axis.ticks.end(), is_at(minor))) << minor;
  EXPECT_FALSE(std::any_of(axis.ticks.begin(), axis.ticks.end(), is_at(0.04)));
}

TEST(AxisTicks, ManyDecadesAreThinned) {
  const std::vector<std::string> texts = labels(logarithmic_ticks(1e-9, 1e9, 6));
  EXPECT_LE(texts.size(), 7u);
  EXPECT_EQ(texts.front(), "10⁻⁹");
}

TEST(AxisTicks, LessThanTwoDecades) {
  EXPECT_EQ(labels(logarithmic_ticks(2, 60, 6)), (std::vector<std::string>{"2", "5", "10", "20", "50"}));
  EXPECT_EQ(labels(logarithmic_ticks(1.1, 1.9, 4)), (std::vector<std::string>{"1.2", "1.4", "1.6", "1.8"}));
}

}  // namespace
}  // namespace secular::report
