// Two dozen draws of the shipped experiment: whether error bars of parameters and lumps hold, and, in the first of
// them, what rounding may move.
#include "continuity.hpp"

#include <gtest/gtest.h>

#include <boost/math/distributions/binomial.hpp>
#include <map>
#include <string>

#include "numerics/confidence.hpp"
#include "recovered_campaign.hpp"

namespace secular {
namespace {

using namespace testing_support;

constexpr std::uint64_t seeds = 24, rounded_seeds = 8;

void jitter(MadeCampaign& made, std::uint64_t seed) {
  for (std::size_t r = 0; r < made.simulated.samples.size(); ++r)
    made.simulated.samples[r] = jittered(made.simulated.samples[r], 1000 * seed + r);
}

// Fewer intervals that hold than this come about once in ten thousand times.
int fewest_that_hold(int intervals) {
  const boost::math::binomial_distribution<double> holds(intervals, 0.95);
  int count = intervals;
  while (count > 0 && boost::math::cdf(holds, count - 1) > 1e-4) --count;
  return count;
}

TEST(SlowContinuity, PrincipalParametricCampaign) {
  std::map<std::string, int> hold;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE(seed);
    MadeCampaign made = make_campaign("principal_parametric", seed);
    const Recovered r = recover(made);
    if (seed <= rounded_seeds) {
      jitter(made, seed);
      expect_continuous(r.estimate, recover(made).estimate);
    }
    for (const auto* list : {&r.estimate.parameters, &r.estimate.lumps})
      for (const EstimatedValue& v : *list) {
        if (!v.value) continue;
        const Interval interval = confidence_interval(*v.value, v.sd, v.degrees_of_freedom);
        const double truth = r.truth(v.name);
        hold[(list == &r.estimate.lumps ? "lump " : "") + v.name] +=
            interval.low <= truth && truth <= interval.high;
      }
  }
  EXPECT_EQ(hold.size(), 13U);
  for (const auto& [name, count] : hold) EXPECT_GE(count, fewest_that_hold(seeds)) << name;
}

TEST(SlowContinuity, PendulumDecay) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    SCOPED_TRACE(seed);
    MadeCampaign made = make_campaign("pendulum_decay", seed);
    const Recovered r = recover(made);
    jitter(made, seed);
    expect_continuous(r.estimate, recover(made).estimate);
  }
}

}  // namespace
}  // namespace secular
