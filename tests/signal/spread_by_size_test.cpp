#include "numerics/spread_by_size.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace secular {
namespace {

using Places = std::vector<std::size_t>;

// One of each part: at its middle, a quarter, three quarters.
TEST(SpreadBySize, UnitsOfOneSizeAreSpreadEvenly) {
  EXPECT_EQ(spread_by_size(std::vector<double>(12, 2.5), 3), (Places{2, 5, 11}));
  EXPECT_EQ(spread_by_size(std::vector<double>(12, 0.0), 3), (Places{2, 5, 11}));
}

// What goes to and fro a whole number of times is met in both directions, at whatever phase it begins;
// docs/inference.md (59). (Middles of the parts meet one direction alone at every phase.)
TEST(SpreadBySize, WhatRepeatsWithThePartsIsMetAtMoreThanOnePhase) {
  constexpr std::size_t units = 160;
  const std::vector<double> sizes(units, 1.0);
  for (const std::size_t kept : {4U, 5U, 8U}) {
    const Places taken = spread_by_size(sizes, kept);
    ASSERT_EQ(taken.size(), kept);
    const std::size_t period = units / kept;
    for (std::size_t phase = 0; phase < period; ++phase) {
      const auto forth = std::count_if(taken.begin(), taken.end(),
                                       [&](std::size_t i) { return (i + phase) % period < period / 2; });
      EXPECT_GE(forth, 1) << kept << " of phase " << phase;
      EXPECT_LT(forth, static_cast<std::ptrdiff_t>(kept)) << kept << " of phase " << phase;
    }
  }
}

// Two places may lie in one unit: no unit is taken twice, and none without a size while others are left.
TEST(SpreadBySize, NoUnitIsTakenTwice) {
  std::mt19937_64 draw(20612);
  std::uniform_real_distribution<double> size(-0.5, 1);
  for (int row = 0; row < 300; ++row) {
    std::vector<double> sizes(static_cast<std::size_t>(4 + row % 20));
    for (double& s : sizes) s = std::max(0.0, size(draw));
    const auto with_size =
        static_cast<std::size_t>(std::count_if(sizes.begin(), sizes.end(), [](double s) { return s > 0; }));
    for (std::size_t kept = 1; kept <= sizes.size(); ++kept) {
      const Places taken = spread_by_size(sizes, kept);
      EXPECT_EQ(std::set<std::size_t>(taken.begin(), taken.end()).size(), kept);
      const auto counted = std::count_if(taken.begin(), taken.end(), [&](std::size_t i) { return sizes[i] > 0; });
      EXPECT_EQ(static_cast<std::size_t>(counted), std::min(kept, with_size));
    }
  }
}

TEST(SpreadBySize, WhatIsLargeIsTakenAndTheRestIsSpread) {
  std::vector<double> sizes(12, 1.0);
  sizes[5] = 100;
  EXPECT_EQ(spread_by_size(sizes, 1), (Places{5}));
  const Places three = spread_by_size(sizes, 3);
  ASSERT_EQ(three.size(), 3U);
  EXPECT_EQ(three[1], 5U);
  EXPECT_LT(three[0], 5U);
  EXPECT_GT(three[2], 5U);
}

TEST(SpreadBySize, UnitsWithoutSizeComeLast) {
  const std::vector<double> sizes = {0, 3, 0, 0, 5, 0};
  EXPECT_EQ(spread_by_size(sizes, 2), (Places{1, 4}));
  const Places three = spread_by_size(sizes, 3);
  ASSERT_EQ(three.size(), 3U);
  EXPECT_EQ(std::count(three.begin(), three.end(), 1U) + std::count(three.begin(), three.end(), 4U), 2);
}

TEST(SpreadBySize, AllAreTakenWhereMoreAreWanted) {
  EXPECT_EQ(spread_by_size(std::vector<double>{1, 0, 2}, 7), (Places{0, 1, 2}));
  EXPECT_TRUE(spread_by_size(std::vector<double>{}, 3).empty());
}

// Each is taken with its share of the sizes: over many rows in which sizes are drawn, a unit of twice the size is
// there twice as often.
TEST(SpreadBySize, UnitsAreTakenInProportionToTheirSize) {
  std::mt19937_64 draw(20611);
  std::uniform_real_distribution<double> size(0.5, 1.5);
  double large = 0, small = 0, of_large = 0, of_small = 0;
  for (int row = 0; row < 400; ++row) {
    std::vector<double> sizes(60);
    for (double& s : sizes) s = size(draw);
    const Places taken = spread_by_size(sizes, 12);
    EXPECT_EQ(std::set<std::size_t>(taken.begin(), taken.end()).size(), 12U);
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      const bool there = std::binary_search(taken.begin(), taken.end(), i);
      (sizes[i] > 1 ? of_large : of_small) += sizes[i];
      if (there) (sizes[i] > 1 ? large : small) += 1;
    }
  }
  // 4800 taken: a standard deviation of either count is below 35.
  EXPECT_NEAR(large, 4800 * of_large / (of_large + of_small), 4 * 35);
  EXPECT_NEAR(small, 4800 * of_small / (of_large + of_small), 4 * 35);
}

}  // namespace
}  // namespace secular
