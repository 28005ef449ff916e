// Free decays: bias of the windows and of the expansion, and what a decay does not determine.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "estimator/model/by_name.hpp"
#include "recovered_campaign.hpp"

namespace secular {
namespace {

using namespace testing_support;

const CompiledModel& two_mass() {
  return *generated::find_compiled_model("two_mass_mode1");
}

Experiment decay_of(double amplitude, double duration_s, double noise_share) {
  Experiment e = shipped_experiment("principal_parametric");
  e.dwells.clear();
  FreeDecayProgramme decay;
  decay.initial_displacement = {amplitude};
  decay.initial_velocity = {0};
  decay.duration_s = duration_s;
  e.free_decays = {decay};
  for (SimulatedChannel& channel : e.responses) {
    channel.noise_sd *= noise_share;
    channel.quantisation = 0;
  }
  return e;
}

struct Corrected {
  Estimate raw, corrected;
};

Corrected identified(const Experiment& e, const std::string& case_name) {
  const CompiledModel& model = two_mass();
  const SimulatedCampaign simulated = run_virtual_test(e, model, 1, 2);
  const ObservationSet set = observed(simulated, model, case_named(model, case_name));
  Corrected result;
  result.raw = estimate(set, "kg^(1/2) m", {"m/s^2"}, {});
  const auto replay = [&](const ObservationSet& measured, const Eigen::VectorXd& parameters) {
    return observe_replay(simulated.campaign, measured, parameters, 2);
  };
  result.corrected =
      correct_truncation(std::span(&set, 1), result.raw, {"kg^(1/2) m", {"m/s^2"}}, {}, replay, [](const char*) {
      }).estimate;
  return result;
}

// What an amplitude of second degree leaves of a steady decay depends on where in a turn the window begins: in one
// without noise that is all there is, and no disturbance.
TEST(Decay, WithoutNoiseHasNoDisturbedWindows) {
  const Recovered r = recover("linear_impulse_response", 1);
  EXPECT_EQ(r.measured.warnings, std::vector<std::string>());
  ASSERT_TRUE(r.value("omega0").value && r.value("mu").value);
  EXPECT_NEAR(*r.value("omega0").value, 1, 1e-6);
  EXPECT_NEAR(*r.value("mu").value, 0.025, 1e-6);
  EXPECT_NEAR(*r.value("a3").value, 0, 1e-5);
}

// Amplitudes of second degree in time leave a rate a bias of the order of (damping rate times window)^2: twice as
// long a decay has windows twice as long. The full equations, seen through the same windows, have the same bias,
// and what is left is small. Without noise and at a small amplitude: this bias alone.
TEST(SlowDecay, BiasFallsWithTheSquareOfTheWindow) {
  const double truth =
      truth_of(two_mass(), case_named(two_mass(), "free"), decay_of(1, 1, 0).parameters, "alpha_e");
  double before = 0;
  for (const double duration : {24.0, 12.0}) {
    const Corrected e = identified(decay_of(1e-3, duration, 1e-6), "free");
    const double raw = *value_of(e.raw, "alpha_e").value / truth - 1;
    const double corrected = *value_of(e.corrected, "alpha_e").value / truth - 1;
    std::printf("decay of %g s: relative bias of alpha_e %.2e, corrected %.2e; mu3 %.5g, corrected %.5g\n",
                duration, raw, corrected, *value_of(e.raw, "mu3").value, *value_of(e.corrected, "mu3").value);
    if (before > 0) {
      EXPECT_NEAR(before / std::abs(raw), 4, 1);
    }
    before = std::abs(raw);
    EXPECT_LT(std::abs(corrected), std::abs(raw));
    const EstimatedValue& v = value_of(e.corrected, "alpha_e");
    EXPECT_LT(std::abs(*v.value - truth), 2 * v.sd);
  }
}

TEST(SlowDecay, WhatItDoesNotDetermineIsSaid) {
  const Corrected e = identified(decay_of(4e-3, 8, 1), "free");
  for (const char* name : {"alpha2", "alpha3", "delta2", "delta3"}) {
    const EstimatedValue& v = value_of(e.corrected, name);
    EXPECT_FALSE(v.identifiable) << name;
    EXPECT_FALSE(v.value) << name;
    EXPECT_FALSE(v.entangled_with.empty()) << name;
  }
  for (const char* name : {"eta1", "eta2"}) {
    EXPECT_FALSE(value_of(e.corrected, name).identifiable) << name;
    EXPECT_FALSE(value_of(e.corrected, name).value) << name;
  }
  EXPECT_TRUE(value_of(e.corrected, "alpha_e").identifiable);
}

// A thousandth of the amplitude: only frequency and viscous damping are there to be seen. Whatever else is given
// has an interval that holds the truth, and is not called significant.
TEST(SlowDecay, ASmallSwingClaimsNoNonlinearity) {
  const Experiment small = decay_of(2e-4, 6, 1);
  const Corrected e = identified(small, "free");
  for (const char* name : {"mu2", "mu3", "alpha_e"}) {
    const EstimatedValue& v = value_of(e.corrected, name);
    if (!v.value) continue;
    EXPECT_LT(std::abs(*v.value - truth_of(two_mass(), case_named(two_mass(), "free"), small.parameters, name)),
              4 * v.sd)
        << name;
  }
}

// A pluck nearly as far as a spring holds (the expansion's terms are of the size of the linear ones there, and one
// decay alone leaves most parameters open): what is given is near the truth, or doubtful.
TEST(SlowDecay, NearWhereTheSpringGivesWayNothingIsGivenWithoutDoubtThatIsWrong) {
  for (const double share : {0.9, 0.95, 0.97, 0.99}) {
    Experiment e = decay_of(0, 12, 0.1);
    const double reach = 5e-3;
    const auto set = [&](const char* name, double value) {
      e.parameters(static_cast<Eigen::Index>(symbol_named(two_mass(), name))) = value;
    };
    for (const char* none : {"alpha3", "delta2", "delta3", "mu2", "mu3"}) set(none, 0);
    set("alpha2", e.parameters(0) * e.parameters(0) / reach);  // no force is left at -reach
    e.free_decays[0].initial_displacement = {-share * reach};
    const Corrected found = identified(e, "free");
    for (const char* name : {"omega0", "mu1"}) {
      const EstimatedValue& v = value_of(found.corrected, name);
      if (!v.value || v.doubtful) continue;
      const double truth = truth_of(two_mass(), case_named(two_mass(), "free"), e.parameters, name);
      EXPECT_LT(std::abs(*v.value - truth), 4 * v.sd) << name << " from " << share;
      EXPECT_LT(v.sd, 0.1 * truth) << name << " from " << share;
    }
  }
}

}  // namespace
}  // namespace secular
