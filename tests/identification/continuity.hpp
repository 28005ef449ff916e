#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "estimator/identification/estimate.hpp"
#include "measure/data/campaign.hpp"

// The law of continuity: an estimate and its error bar are continuous functions of the samples. A relative change
// of 1e-9, far below any noise and above rounding, moves no number by more than 0.01 standard deviations, and no
// standard deviation by more than 1 %. What breaks it hangs on rounding, and differs between processors.
namespace secular::testing_support {

inline Record jittered(Record record, std::uint64_t seed) {
  constexpr double relative = 1e-9;
  std::mt19937_64 random(seed);
  for (std::vector<double>& channel : record.channels)
    for (double& x : channel) x *= 1 + relative * (std::ldexp(static_cast<double>(random() >> 11), -52) - 1);
  return record;
}

inline void expect_continuous(const std::vector<EstimatedValue>& values, const std::vector<EstimatedValue>& moved) {
  ASSERT_EQ(values.size(), moved.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string name = values[i].resonance + " " + values[i].name;
    ASSERT_EQ(values[i].value.has_value(), moved[i].value.has_value()) << name;
    if (!values[i].value || values[i].fixed) continue;
    EXPECT_LT(std::abs(*moved[i].value - *values[i].value), 0.01 * values[i].sd) << name;
    EXPECT_LT(std::abs(moved[i].sd - values[i].sd), 0.01 * values[i].sd) << name;
  }
}

inline void expect_continuous(const Estimate& estimate, const Estimate& moved) {
  expect_continuous(estimate.parameters, moved.parameters);
  expect_continuous(estimate.lumps, moved.lumps);
}

}  // namespace secular::testing_support
