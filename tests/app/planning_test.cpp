// `secular plan` against the programme in use: predicted quickly, shown by simulation.
#include "jobs/plan/planning.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

#include "estimator/identification/estimate.hpp"
#include "input/input_error.hpp"
#include "jobs/plan/dwell_evaluation.hpp"
#include "jobs/plan/plan_inputs.hpp"
#include "numerics/hertz.hpp"
#include "tests/procedures/noisy_campaign.hpp"
#include "tests/process_folder.hpp"
#include "tests/sensor_noise.hpp"

namespace secular::app {
namespace {

namespace fs = std::filesystem;

PlanRequest chapter_5() {
  PlanRequest request;
  request.model = "two_mass_mode1";
  request.resonance = "principal_parametric";
  request.parameters = "predictions/table_5_4";
  request.wanted = {"mu1", "mu3", "alpha_e", "eta_e"};
  request.fixed = {"mu2"};
  request.lowest_hz = 24.4;
  request.highest_hz = 25.05;
  request.lowest_amplitude = 12;
  request.highest_amplitude = 30;
  request.frequencies = 27;
  request.levels = 4;
  request.against = "experiments/thesis_chapter5";
  return request;
}

const PlanResult& plan_of_chapter_5() {
  static const PlanResult plan = plan_test(chapter_5());
  return plan;
}

// Coordinates are the displacements of the channels, the excitation is a force.
TEST(PlanUnits, AreThoseOfTheCampaignInUse) {
  PlanRequest request = chapter_5();
  request.against.clear();
  const PlanResult modal = plan_inputs(request);
  request.against = "laboratory";
  request.campaign.emplace();
  request.campaign->channels = {{"force", ChannelRole::excitation, Quantity::force, "N"},
                                {"tip", ChannelRole::response, Quantity::acceleration, "m/s^2"}};
  const PlanResult plan = plan_inputs(request);
  const auto unit_of = [](const PlanResult& of, const std::string& name) {
    const auto at = std::find(of.unknowns.names.begin(), of.unknowns.names.end(), name);
    return of.units.at(static_cast<std::size_t>(at - of.unknowns.names.begin()));
  };
  EXPECT_EQ(modal.coordinate_unit, "kg^(1/2) m");
  EXPECT_EQ(unit_of(modal, "alpha_e"), "1/(kg m^2 s^2)");
  EXPECT_EQ(unit_of(modal, "eta_e"), "1/m");
  EXPECT_EQ(plan.coordinate_unit, "m");
  EXPECT_EQ(unit_of(plan, "mu1"), "1/s");
  EXPECT_EQ(unit_of(plan, "alpha_e"), "1/(m^2 s^2)");
  EXPECT_EQ(unit_of(plan, "eta_e"), "1/(N s^2)");
}

TEST(SlowPlan, ReachesTheChapter5ProgrammeInHalfItsTime) {
  const PlanResult& plan = plan_of_chapter_5();
  ASSERT_TRUE(plan.against);
  EXPECT_TRUE(plan.meets_target);
  EXPECT_LE(plan.plan.time_s, 0.5 * plan.against->time_s);
  EXPECT_LT(plan.plan.time_s, 0.7 * plan.against->settled_time_s) << "not by settling less alone";
  for (const Eigen::Index w : plan.wanted)
    EXPECT_LE(plan.plan.sd(w), plan.against->sd(w)) << plan.unknowns.names[static_cast<std::size_t>(w)];
  // Error bars from the scatter between dwells need more dwells than the equation has columns.
  EXPECT_GE(plan.plan.dwells.size(), 8u);
}

TEST(SlowPlan, ABudgetIsKeptAndMoreOfItIsNotWorse) {
  PlanRequest request = chapter_5();
  request.against.clear();
  request.levels = 2;
  request.criterion = DesignCriterion::c;
  request.wanted = {"mu3"};
  double last = 1e300;
  for (const double budget : {600.0, 1200.0}) {
    request.budget_s = budget;
    const PlanResult plan = plan_test(request);
    EXPECT_LE(plan.plan.time_s, budget);
    EXPECT_LT(plan.plan.sd(plan.wanted[0]), last);
    last = plan.plan.sd(plan.wanted[0]);
  }
}

TEST(Plan, BeginsWithTheSensorsInUseAndAGridOfTheRanges) {
  const PlanRequest request = chapter_5();
  const PlanResult plan = plan_inputs(request);
  EXPECT_EQ(plan.resonance->name, "principal_parametric");
  ASSERT_EQ(plan.wanted.size(), request.wanted.size());
  for (std::size_t w = 0; w < plan.wanted.size(); ++w)
    EXPECT_EQ(plan.unknowns.names[static_cast<std::size_t>(plan.wanted[w])], request.wanted[w]);
  EXPECT_EQ(plan.units.size(), plan.unknowns.names.size());
  ASSERT_TRUE(plan.sensors);
  EXPECT_EQ(plan.noise.sample_rate_hz, plan.sensors->sample_rate_hz);
  const CandidateRequest grid = DwellEvaluation(request, plan).grid();
  ASSERT_EQ(grid.frequencies.size(), 27u);
  EXPECT_NEAR(grid.frequencies.front(), two_pi * 24.4, 1e-9);
  EXPECT_NEAR(grid.frequencies.back(), two_pi * 25.05, 1e-9);
  EXPECT_EQ(grid.forcings, (std::vector<double>{12, 18, 24, 30}));
}

TEST(Plan, SaysWhatItCannotDo) {
  const auto message = [](PlanRequest request) -> std::string {
    try {
      plan_test(request);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  PlanRequest request = chapter_5();
  request.wanted = {"alpha3"};
  EXPECT_NE(message(request).find("--for alpha3"), std::string::npos);
  request = chapter_5();
  request.criterion = DesignCriterion::c;
  EXPECT_NE(message(request).find("is for one parameter"), std::string::npos);
  request = chapter_5();
  request.highest_hz = request.lowest_hz;
  EXPECT_NE(message(request).find("--range-frequency"), std::string::npos);
  request = chapter_5();
  request.resonance = "secondary";
  EXPECT_NE(message(request).find("principal_parametric"), std::string::npos);
}

// Scatter of the estimates over noise draws of both campaigns on the full equations of motion.
TEST(SlowPlan, ThePlannedCampaignIsAsSharpAsTheThesisCampaign) {
  const int seeds = testing_support::number_from("SECULAR_SEEDS", 16);
  const PlanRequest request = chapter_5();
  const PlanResult& plan = plan_of_chapter_5();
  const fs::path file = testing_support::process_folder() / "secular_planned_chapter5.toml";
  std::ofstream(file) << plan_experiment(request, plan);
  const CompiledModel& model = *generated::find_compiled_model("two_mass_mode1");
  std::map<std::string, double> variance[2];
  for (const int which : {0, 1}) {
    const testing_support::NoisyCampaign campaign(
        which == 0 ? read_experiment(file, model) : testing_support::NoisyCampaign::shipped("thesis_chapter5"));
    std::map<std::string, double> sum, square;
    std::map<std::string, double> reference;
    for (int seed = 1; seed <= seeds; ++seed) {
      EstimateOptions options;
      options.fixed["mu2"] = 0;
      const Estimate fit =
          estimate(campaign.observe(static_cast<std::uint64_t>(seed)), campaign.unit(), {"m/s^2"}, options);
      for (const EstimatedValue& lump : fit.lumps) {
        if (!lump.value || lump.fixed) continue;
        const double value = *lump.value - reference.try_emplace(lump.name, *lump.value).first->second;
        sum[lump.name] += value;
        square[lump.name] += value * value;
      }
    }
    for (const auto& [name, s] : sum) variance[which][name] = (square[name] - s * s / seeds) / (seeds - 1);
  }
  fs::remove(file);
  // Equal variances would give a larger ratio than this once in a thousand tests.
  const double limit =
      boost::math::quantile(boost::math::complement(boost::math::fisher_f(seeds - 1.0, seeds - 1.0), 1e-3));
  EXPECT_LE(plan.plan.time_s, 0.5 * plan.against->time_s);
  for (const Eigen::Index w : plan.wanted) {
    const std::string name = plan.unknowns.names[static_cast<std::size_t>(w)];
    EXPECT_LT(variance[0].at(name) / variance[1].at(name), limit) << name;
    std::printf("%-8s sd planned %.3g (predicted %.3g), in use %.3g (predicted %.3g)\n", name.c_str(),
                std::sqrt(variance[0].at(name)), plan.plan.sd(w), std::sqrt(variance[1].at(name)),
                plan.against->sd(w));
    // The prediction itself, both ways: chi-square over its degrees of freedom is inside [1/limit, limit] too.
    EXPECT_LT(variance[0].at(name), limit * std::pow(plan.plan.sd(w), 2)) << name;
  }
  std::printf("laboratory time %.0f s against %.0f s (%.0f s with the plan's settling)\n", plan.plan.time_s,
              plan.against->time_s, plan.against->settled_time_s);
}

}  // namespace
}  // namespace secular::app
