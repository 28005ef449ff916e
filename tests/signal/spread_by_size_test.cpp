#include "numerics/spread_by_size.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace secular {
namespace {

using Places = std::vector<std::size_t>;

TEST(SpreadBySize, UnitsOfOneSizeAreSpreadEvenly) {
  EXPECT_EQ(spread_by_size(std::vector<double>(12, 2.5), 3), (Places{2, 6, 10}));
  EXPECT_EQ(spread_by_size(std::vector<double>(12, 0.0), 3), (Places{2, 6, 10}));
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
