// Virtual tests of known parameters, identified: every true value inside its error bar.
#include <gtest/gtest.h>

#include <cmath>

#include "estimator/identification/unit_text.hpp"
#include "input/input_error.hpp"
#include "recovered_campaign.hpp"

namespace secular {
namespace {

using testing_support::recover;
using testing_support::Recovered;

TEST(DrawnCampaign, IsTheSimulationOfItsSeed) {
  const testing_support::MadeCampaign drawn = testing_support::DrawnCampaign("linear_impulse_response").drawn(4),
                                      simulated = testing_support::make_campaign("linear_impulse_response", 4);
  ASSERT_EQ(drawn.simulated.samples.size(), simulated.simulated.samples.size());
  for (std::size_t r = 0; r < drawn.simulated.samples.size(); ++r)
    EXPECT_EQ(drawn.simulated.samples[r].channels, simulated.simulated.samples[r].channels) << r;
}

TEST(Recovery, PrincipalParametricCampaignWithTheThesisValues) {
  const testing_support::DrawnCampaign campaign("principal_parametric");
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Recovered r = recover(campaign.drawn(seed));
    for (const char* name : {"omega0", "mu1", "mu2", "mu3", "eta1", "eta2", "alpha_e", "eta_e", "alpha_q"}) {
      const EstimatedValue& v = r.value(name);
      ASSERT_TRUE(v.value) << name;
      EXPECT_LT(std::abs(*v.value - r.truth(name)), 3 * v.sd) << name << ", seed " << seed;
    }
    for (const char* name : {"mu1", "mu3", "alpha_e", "eta_e"})
      EXPECT_LT(r.value(name).sd, 0.05 * std::abs(r.truth(name))) << name;
  }
}

TEST(Recovery, WhatTheDataCannotSeparateIsNamed) {
  const Recovered r = recover("principal_parametric", 1);
  for (const char* name : {"alpha2", "alpha3", "delta2", "delta3"}) {
    EXPECT_FALSE(r.value(name).identifiable) << name;
    EXPECT_FALSE(r.value(name).value) << name;
    EXPECT_EQ(r.value(name).entangled_with.size(), 3U) << name;
  }
  EXPECT_EQ(r.value("mu3").unit, "s/m^2");
  EXPECT_EQ(r.value("eta_e").unit, "1/m");
}

TEST(Recovery, FixedParametersAreGivenAndSharpenTheOthers) {
  const testing_support::MadeCampaign made = testing_support::make_campaign("principal_parametric", 1);
  const Recovered open = recover(made), fixed = recover(made, {{{"mu2", 0.0}}});
  EXPECT_TRUE(fixed.value("mu2").fixed);
  // The law that is hard to tell from the one that is given. (The error of mu1 is mostly what the truncation's
  // correction leaves open.)
  EXPECT_LT(fixed.value("mu3").sd, open.value("mu3").sd);
  EXPECT_LT(std::abs(*fixed.value("mu3").value - fixed.truth("mu3")), 3 * fixed.value("mu3").sd);
  EXPECT_THROW(recover(made, {{{"nu", 0.0}}}), InputError);
}

TEST(Recovery, PendulumDecay) {
  const Recovered r = recover("pendulum_decay", 1);
  for (const char* name : {"omega0", "alpha3", "alpha5", "mu1", "mu2", "fc"}) {
    const EstimatedValue& v = r.value(name);
    ASSERT_TRUE(v.value) << name;
    EXPECT_LT(std::abs(*v.value - r.truth(name)), 3 * v.sd) << name << " " << *v.value << " sd " << v.sd;
  }
  EXPECT_LT(r.value("alpha3").sd, 0.01 * std::abs(r.truth("alpha3")));
}

TEST(Units, FromDimensions) {
  const Ratio s_per_length_squared[] = {{-2, 1}, {0, 1}, {1, 1}};
  EXPECT_EQ(unit_text(s_per_length_squared, {"kg^(1/2) m"}, {"m/s^2"}), "s/(kg m^2)");
  const Ratio parametric[] = {{0, 1}, {-1, 1}, {-2, 1}};
  EXPECT_EQ(unit_text(parametric, {"kg^(1/2) m"}, {"m/s^2"}), "1/m");
  EXPECT_EQ(unit_text({}, {"m"}, {}), "");
}

}  // namespace
}  // namespace secular
