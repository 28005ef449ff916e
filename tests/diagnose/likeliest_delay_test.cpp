#include "diagnose/evidence/likeliest_delay.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <optional>

namespace secular {
namespace {

constexpr double period = 0.05;

double turn(double seconds) {
  return 2 * std::numbers::pi * seconds / period;
}

TEST(LikeliestDelay, IsWhereTheResidualIsLeastWhereverItBegins) {
  const double late = 0.0123;
  const auto misfit = [&](double seconds) {
    return 1e4 * std::norm(std::polar(1.0, turn(seconds)) - std::polar(1.0, turn(late)));
  };
  for (const double here : {0.0, 0.02, -0.013, late + 0.5 * period, 3 * period})
    EXPECT_NEAR(std::remainder(likeliest_delay(misfit, here, period) - late, period), 0, 1e-4 * period) << here;
}

// Errors of two combinations of a row pair, one known a hundred times better: the axes turn with the delay, and the
// misfit has a second, shallow minimum.
TEST(LikeliestDelay, IsTheDeepestOfSeveralMinima) {
  const auto misfit = [](double seconds) {
    return 100 * (1 - std::cos(2 * turn(seconds - 0.004))) + 30 * (1 - std::cos(turn(seconds - 0.004)));
  };
  EXPECT_NEAR(std::remainder(likeliest_delay(misfit, 0.004 + 0.5 * period, period) - 0.004, period), 0,
              1e-4 * period);
}

TEST(LikeliestDelay, DoesNotGoWhereThereIsNoMotion) {
  const auto misfit = [](double seconds) {
    return seconds < 0 ? std::numeric_limits<double>::infinity() : std::pow(seconds - 0.01, 2);
  };
  EXPECT_NEAR(likeliest_delay(misfit, 0, period), 0.01, 1e-4 * period);
}

TEST(LikeliestDelay, CloseByAParabolaFindsItAndFartherOffNothing) {
  const double late = 0.0123;
  const auto misfit = [&](double seconds) {
    return 1e4 * std::norm(std::polar(1.0, turn(seconds)) - std::polar(1.0, turn(late))) +
           300 * std::sin(3 * turn(seconds - late)) - 900 * std::sin(turn(seconds - late));
  };
  for (const double off : {-0.007, -0.001, 0.0, 0.004, 0.007}) {
    const std::optional<double> found = likeliest_delay_near(misfit, late + off * period, period);
    ASSERT_TRUE(found) << off;
    EXPECT_NEAR(*found, late, 2e-4 * period) << off;
  }
  for (const double off : {-0.02, 0.01, 0.3, 0.5})
    EXPECT_FALSE(likeliest_delay_near(misfit, late + off * period, period)) << off;
  EXPECT_FALSE(likeliest_delay_near([](double) { return 3.0; }, 0, period));
  EXPECT_FALSE(likeliest_delay_near([](double) { return std::numeric_limits<double>::infinity(); }, 0, period));
}

TEST(LikeliestDelay, StaysWhereNothingTells) {
  const double found = likeliest_delay([](double) { return 3.0; }, 0.01, period);
  EXPECT_NEAR(found, 0.01, period / 16);
}

}  // namespace
}  // namespace secular
