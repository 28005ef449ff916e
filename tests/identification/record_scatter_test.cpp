// Decays of a structure whose natural frequency differs from record to record: error bars have to know it.
#include "estimator/identification/record_scatter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>

#include "motion/correction/replay.hpp"
#include "motion/correction/truncation_correction.hpp"
#include "motion/simulate/noise.hpp"
#include "numerics/confidence.hpp"
#include "virtual_campaign.hpp"

namespace secular {
namespace {

using namespace testing_support;

constexpr double amplitudes[] = {0.9, 0.75, 0.6, 0.5, 0.8};

// One campaign of decays, each of a pendulum with its own natural frequency.
SimulatedCampaign decays(const Experiment& experiment, const CompiledModel& model, double scatter,
                         std::uint64_t seed) {
  NoiseStream noise(seed, 77, 0);
  SimulatedCampaign all;
  for (std::size_t r = 0; r < std::size(amplitudes); ++r) {
    Experiment one = experiment;
    one.parameters(0) *= 1 + scatter * noise.gaussian();
    one.free_decays.front().initial_displacement = {amplitudes[r]};
    one.free_decays.front().duration_s = 30;
    for (SimulatedChannel& channel : one.responses) {
      channel.noise_sd = 5e-4;
      channel.quantisation = 0;
    }
    SimulatedCampaign made = run_virtual_test(one, model, 10 * seed + r, 2);
    if (r == 0) {
      all = std::move(made);
    } else {
      all.campaign.records.push_back(made.campaign.records.front());
      all.samples.push_back(std::move(made.samples.front()));
    }
  }
  return all;
}

Estimate identified(const SimulatedCampaign& simulated, const CompiledModel& model) {
  const ObservationSet set = observed(simulated, model, case_named(model, "free"));
  const MeasuredUnits units{"rad", {}};
  EstimateOptions options;
  options.damping_laws = false;
  const Estimate raw = estimate(std::span(&set, 1), units, options);
  const auto replay = [&](const ObservationSet& measured, const Eigen::VectorXd& parameters) {
    return observe_replay(simulated.campaign, measured, parameters, 2);
  };
  return correct_truncation(std::span(&set, 1), raw, units, options, replay, [](const char*) {}).estimate;
}

TEST(SlowRecordScatter, IsInTheErrorBars) {
  const Experiment experiment = shipped_experiment("pendulum_decay");
  const CompiledModel& model = *generated::find_compiled_model(experiment.model);
  const double truth = experiment.parameters(0);
  double quiet = 0;
  for (const double scatter : {0.0, 0.003}) {
    double held = 0, count = 0, square = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const Estimate estimate = identified(decays(experiment, model, scatter, seed), model);
      const EstimatedValue& v = value_of(estimate, "omega0");
      ASSERT_TRUE(v.value) << scatter << ", " << seed;
      const Interval interval = confidence_interval(*v.value, v.sd, v.degrees_of_freedom);
      ++count;
      held += interval.low <= truth && truth <= interval.high;
      square += v.sd * v.sd / (truth * truth);
      EXPECT_LT(std::abs(*v.value - truth), 6 * v.sd) << scatter << ", " << seed;
      EXPECT_FALSE(estimate.lack_of_fit.empty());
      for (const CaseLackOfFit& tests : estimate.lack_of_fit)  // how records differ is no law that the model lacks
        for (const LackOfFit& test : tests.equations)
          EXPECT_FALSE(test.significant) << test.name << ", " << scatter << ": " << test.misfit;
    }
    const double sd = std::sqrt(square / count);
    if (scatter == 0)
      quiet = sd;
    else  // between what five records of equal weight would give and what one would, each times the 0.1 % limits of
          // the root of a mean square with 16 degrees of freedom
      EXPECT_TRUE(sd > 0.5 * scatter / std::sqrt(5.0) && sd < 1.6 * scatter) << scatter << ": " << sd;
    EXPECT_GE(held, 0.95 * count - 3 * std::sqrt(0.05 * 0.95 * count));
  }
  EXPECT_LT(quiet, 1e-4);
}

}  // namespace
}  // namespace secular
