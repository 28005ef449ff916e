// The thesis's campaigns with the models that they were made with, from samples to error bars, in several noise
// draws: the full equations are integrated once, everything after the noise is done again. SECULAR_COVERAGE_DRAWS
// asks for more draws than the few of a test run and for the table of how often each interval holds the truth,
// SECULAR_COVERAGE_FIRST for those from this one on, SECULAR_COVERAGE_FIXED=delta31,delta33 gives the
// identification these true values, SECULAR_COVERAGE_REFINE asks for maximum likelihood.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "app/identification.hpp"
#include "app/model_loading.hpp"
#include "estimator/regression/confidence.hpp"
#include "simulate/noise.hpp"
#include "tests/identification/virtual_campaign.hpp"

namespace secular::app {
namespace {

// One of them as it would be measured without noise.
class ThesisCampaign {
 public:
  static const ThesisCampaign& chapter_five() {
    static const ThesisCampaign campaign("thesis_chapter5", "principal_parametric");
    return campaign;
  }
  static const ThesisCampaign& chapter_six() {
    static const ThesisCampaign campaign("thesis_chapter6", "additive_combination");
    return campaign;
  }

  Estimate identified(int draw, const std::map<std::string, double>& fixed = {}) const {
    const RecordReader read = [&](std::size_t r) {
      Record record = exact_.samples[r];
      for (std::size_t c = 0; c < record.channels.size(); ++c) {
        const double sd = c == 0 ? experiment_.excitation->noise_sd : experiment_.responses[c - 1].noise_sd;
        NoiseStream noise(static_cast<std::uint64_t>(draw) + 1, r, c);
        for (double& x : record.channels[c]) x += sd * noise.gaussian();
      }
      return record;
    };
    IdentificationRequest request;
    request.campaign = experiment_.name;
    request.model = experiment_.model;
    request.threads = 2;
    request.fixed = fixed;
    request.refine = std::getenv("SECULAR_COVERAGE_REFINE") != nullptr;
    return identify(request, exact_.campaign, read).estimate;
  }

  std::map<std::string, double> truth() const {
    std::map<std::string, double> values;
    for (std::size_t p = 0; p < model_->symbols.size(); ++p)
      values[std::string(model_->symbols[p].name)] = experiment_.parameters(static_cast<Eigen::Index>(p));
    return values;
  }
  std::map<std::string, double> true_values(const std::vector<std::string>& names) const {
    std::map<std::string, double> values;
    for (const std::string& name : names) values[name] = truth().at(name);
    return values;
  }

 private:
  ThesisCampaign(const std::string& name, const std::string& resonance)
      : experiment_(testing_support::shipped_experiment(name)),
        model_(ModelSource(experiment_.model, false).load({resonance})) {
    Experiment quiet = experiment_;
    quiet.excitation->noise_sd = 0;
    for (SimulatedChannel& channel : quiet.responses) channel.noise_sd = 0;
    exact_ = run_virtual_test(quiet, *model_, 1, 2);
  }

  Experiment experiment_;
  std::shared_ptr<const CompiledModel> model_;
  SimulatedCampaign exact_;
};

struct Coverage {
  int inside = 0, count = 0;
  double error = 0, square = 0, sd = 0;
};

// No draw is contradicted by its lumps or doubts a number, and none is far from the truth. Mean degrees of freedom
// of the lumps against one another.
double expect_intervals_to_hold(const ThesisCampaign& campaign) {
  const char* text = std::getenv("SECULAR_COVERAGE_DRAWS");
  const char* first_text = std::getenv("SECULAR_COVERAGE_FIRST");
  const int draws = text ? std::atoi(text) : 2, first = first_text ? std::atoi(first_text) : 0;
  std::map<std::string, double> fixed;
  if (const char* names = std::getenv("SECULAR_COVERAGE_FIXED")) {
    std::istringstream list(names);
    for (std::string name; std::getline(list, name, ',');) fixed.merge(campaign.true_values({name}));
  }
  const std::map<std::string, double> truth = campaign.truth();
  std::map<std::string, Coverage> table;
  int contradictions = 0;
  double chi_squared = 0, freedom = 0;
  for (int draw = first; draw < first + draws; ++draw) {
    const Estimate estimate = campaign.identified(draw, fixed);
    contradictions += estimate.consistency.significant;
    if (text)
      std::printf("draw %d: chi-squared %.1f on %.0f, p = %.2g\n", draw, estimate.consistency.chi_squared,
                  estimate.consistency.degrees_of_freedom, estimate.consistency.p_value);
    chi_squared += estimate.consistency.chi_squared / draws;
    freedom += estimate.consistency.degrees_of_freedom / draws;
    for (const EstimatedValue& v : estimate.parameters) {
      if (!v.value || v.fixed) continue;
      EXPECT_FALSE(v.doubtful) << v.name;
      const double error = *v.value - truth.at(v.name);
      const Interval interval = confidence_interval(*v.value, v.sd, v.degrees_of_freedom);
      Coverage& c = table[v.name];
      c.inside += interval.low <= truth.at(v.name) && truth.at(v.name) <= interval.high;
      c.error += error;
      c.square += error * error;
      c.sd += v.sd;
      ++c.count;
      EXPECT_GT(two_sided_p_value(error / v.sd, v.degrees_of_freedom), 1e-5) << v.name;
    }
  }
  EXPECT_LE(contradictions, draws / 50);
  std::printf("chi-squared of the lumps against one another: mean %.1f on %.1f, contradictions %d of %d\n",
              chi_squared, freedom, contradictions, draws);
  for (const auto& [name, c] : table)
    std::printf("%-8s bias %10.3e  scatter %9.3e  mean sd %9.3e  covered %5.1f %% of %d\n", name.c_str(),
                c.error / c.count, std::sqrt(std::max(0.0, c.square / c.count - std::pow(c.error / c.count, 2))),
                c.sd / c.count, 100.0 * c.inside / c.count, c.count);
  return freedom;
}

TEST(SlowChapterFive, IntervalsHold) {
  expect_intervals_to_hold(ThesisCampaign::chapter_five());
}

TEST(SlowChapterSix, LumpsOfTheRightModelGoTogetherAndIntervalsHold) {
  EXPECT_GE(expect_intervals_to_hold(ThesisCampaign::chapter_six()), 20);
}

void expect_settled(const Estimate& estimate) {
  EXPECT_FALSE(estimate.consistency.significant) << estimate.consistency.p_value;
  for (const EstimatedValue& v : estimate.parameters) EXPECT_FALSE(v.doubtful) << v.name;
}

TEST(SlowChapterSix, CorrectionsThatBeginFarAwaySettle) {
  const ThesisCampaign& campaign = ThesisCampaign::chapter_six();
  // Fourteen standard deviations from the raw estimate to where its correction comes to rest: slopes that were seen
  // there lead nowhere, and weights that belong there make good steps look bad.
  expect_settled(campaign.identified(59, campaign.true_values({"delta31", "delta33", "delta34", "delta36"})));
  // The second correction has coefficients that make far more noise of the measurement's: the errors of the columns
  // have to follow, or the lumps that they seem to drown are given up.
  expect_settled(campaign.identified(336));
}

// Without coupled damping, lumps that it is part of cannot go together.
TEST(SlowChapterSix, AMissingTermIsAContradiction) {
  const Estimate estimate = ThesisCampaign::chapter_six().identified(0, {{"mu12", 0.0}});
  bool told = estimate.consistency.significant;
  for (const CaseLackOfFit& tests : estimate.lack_of_fit)
    for (const LackOfFit& test : tests.equations) told = told || test.significant;
  EXPECT_TRUE(told);
}

}  // namespace
}  // namespace secular::app
