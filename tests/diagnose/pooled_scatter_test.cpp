#include "diagnose/evidence/pooled_scatter.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace secular {
namespace {

// Dwells at frequencies within a few percent of one resonance, each with five harmonics.
std::vector<LineScatter> scattering_dwells(int count, double (*sd_at)(double)) {
  std::vector<LineScatter> lines;
  for (int d = 0; d < count; ++d)
    for (int harmonic = 1; harmonic <= 5; ++harmonic) {
      const double frequency = harmonic * 60 * (1 + 0.002 * d);
      lines.push_back({frequency, sd_at(frequency), 10});
    }
  return lines;
}

double red(double frequency) {
  return 1 / (frequency * frequency);
}

TEST(PooledScatter, FollowsColouredNoise) {
  const PooledScatter scatter(scattering_dwells(20, red));
  for (const double frequency : {60.0, 121.0, 185.0, 310.0})
    EXPECT_NEAR(scatter.sd({frequency}), red(frequency), 0.06 * red(frequency)) << frequency;
}

TEST(PooledScatter, TakesAllLinesWhereThereAreFew) {
  const PooledScatter scatter({{10, 1, 10}, {100, 2, 30}});
  const double all = std::sqrt((1.0 * 10 + 4.0 * 30) / 40);
  EXPECT_DOUBLE_EQ(scatter.sd({10}), all);
  EXPECT_DOUBLE_EQ(scatter.sd({1000}), all);
  EXPECT_EQ(PooledScatter({}).sd({10}), 0);
}

TEST(PooledScatter, LeavesOutADisturbedDwell) {
  std::vector<LineScatter> lines = scattering_dwells(21, [](double) { return 1.0; });
  for (std::size_t l = 50; l < 55; ++l) lines[l].sd = 100;
  const PooledScatter scatter(lines);
  for (const double frequency : {61.0, 122.0, 305.0}) EXPECT_DOUBLE_EQ(scatter.sd({frequency}), 1);
  EXPECT_DOUBLE_EQ(scatter.sd(lines[50]), 100);
}

TEST(PooledScatter, TakesMeansTogether) {
  const PooledScatter scatter({{0, 1, 5}, {0, 3, 5}});
  EXPECT_DOUBLE_EQ(scatter.sd({0}), std::sqrt(5.0));
}

}  // namespace
}  // namespace secular
