// What rounding may move: two dozen draws of the shipped experiment, of which the error bars of parameters and
// lumps are asked, too, and a few of the others.
#include "continuity.hpp"

#include <gtest/gtest.h>

#include <boost/math/distributions/binomial.hpp>
#include <cstdint>
#include <map>
#include <string>

#include "numerics/confidence.hpp"
#include "recovered_campaign.hpp"

namespace secular {
namespace {

using namespace testing_support;

constexpr std::uint64_t seeds = 24;

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
  const DrawnCampaign campaign("principal_parametric");
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE(seed);
    MadeCampaign made = campaign.drawn(seed);
    const Recovered r = recover(made);
    jitter(made, seed);
    expect_continuous(r.estimate, recover(made).estimate);
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

// Both thesis campaigns are asked where their coverage is. Of a campaign without noise (linear_impulse_response) it
// is asking too much. Two others determine next to nothing, and that may not hang on rounding, either.
struct ShippedCampaign {
  const char* experiment;
  const char* resonance = "";
  std::uint64_t seeds = 4;
};
class SlowContinuityOf : public ::testing::TestWithParam<ShippedCampaign> {};

TEST_P(SlowContinuityOf, Rounding) {
  const DrawnCampaign campaign(GetParam().experiment, GetParam().resonance);
  for (std::uint64_t seed = 1; seed <= GetParam().seeds; ++seed) {
    SCOPED_TRACE(seed);
    MadeCampaign made = campaign.drawn(seed);
    const Recovered r = recover(made);
    jitter(made, seed);
    expect_continuous(r.estimate, recover(made).estimate);
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, SlowContinuityOf,
                         ::testing::Values(ShippedCampaign{"pendulum_decay"},
                                           ShippedCampaign{"primary_resonance", "primary"},
                                           ShippedCampaign{"shaker_distortion", "primary", 2},
                                           ShippedCampaign{"two_mass_structure", "", 2}),
                         [](const auto& shipped) { return std::string(shipped.param.experiment); });

}  // namespace
}  // namespace secular
