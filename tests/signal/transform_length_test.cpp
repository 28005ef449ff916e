#include "measure/signal/transform_length.hpp"

#include <gtest/gtest.h>

namespace secular {
namespace {

using Eigen::Index;

// Products of 2, 3 and 5 below 3000, made from their exponents.
std::vector<bool> fast_lengths() {
  std::vector<bool> fast(3001, false);
  for (std::size_t a = 1; a <= 3000; a *= 2)
    for (std::size_t b = a; b <= 3000; b *= 3)
      for (std::size_t c = b; c <= 3000; c *= 5) fast[c] = true;
  return fast;
}

TEST(TransformLength, IsTheNearestFastOneOnItsSide) {
  const std::vector<bool> fast = fast_lengths();
  for (Index n = 2; n <= 2900; ++n) {
    Index above = n, below = n / 2 * 2;
    while (!fast[static_cast<std::size_t>(above)]) ++above;
    while (!fast[static_cast<std::size_t>(below)]) below -= 2;
    EXPECT_EQ(padded_transform_length(n), above) << n;
    EXPECT_EQ(cut_transform_length(n), below) << n;
  }
}

}  // namespace
}  // namespace secular
