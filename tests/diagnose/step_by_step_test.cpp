// The strategy of a diagnosis, called as a library: what `secular diagnose` answers.
#include "diagnose/verdict/step_by_step.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "estimator/model/by_name.hpp"
#include "generated/registry.hpp"
#include "input/input_error.hpp"
#include "measure/disturbances/catalogue.hpp"
#include "tests/diagnose/pendulum_swing.hpp"

namespace secular {
namespace {

class StepByStep : public testing::Test {
 protected:
  StepByStep() {
    data = testing_support::simulated(model, testing_support::pendulum_swing(0.01, 0), 12);
    for (std::size_t s = 0; s < model.symbols.size(); ++s) own.push_back(s);
  }

  // A tone of 7.3 Hz in the reading.
  void add_hum(double amplitude) {
    std::vector<double>& reading = data.samples.front().channels.front();
    for (std::size_t i = 0; i < reading.size(); ++i)
      reading[i] += amplitude * std::sin(2 * std::numbers::pi * 7.3 * static_cast<double>(i) / 100);
  }

  void withhold_drag() {
    const std::size_t drag = symbol_named(model, "mu2");
    std::erase(own, drag);
    effects.push_back({"quadratic_damping", 0, "v", drag, {}});
  }

  CampaignAndModel sides() const {
    return {data.campaign, [this](std::size_t r) { return data.samples[r]; }, model, own};
  }
  Diagnosis at_once() const { return diagnose(sides(), effects, {}); }
  StepwiseDiagnosis by_steps(const EstimatedParameters& identified = {}) const {
    return diagnose_step_by_step(sides(), effects, {}, find_disturbances(data.campaign, 0, data.samples.front()),
                                 identified);
  }

  const CompiledModel& model = *generated::find_compiled_model("pendulum");
  SimulatedCampaign data;
  std::vector<std::size_t> own;
  std::vector<EquationEffect> effects;
};

TEST_F(StepByStep, WithoutAnythingOfTheRecordsOwnTheAnswerIsThatOfOneDiagnosis) {
  withhold_drag();
  int asked = 0;
  const StepwiseDiagnosis found = by_steps([&]() -> std::vector<EstimatedValue> {
    ++asked;
    throw InputError("campaign", "", "is one decay", "several");
  });
  const Diagnosis single = at_once();
  EXPECT_EQ(found.diagnosis.cause, "quadratic_damping");
  EXPECT_EQ(found.diagnosis.cause, single.cause);
  EXPECT_EQ(found.diagnosis.gap.closed, single.gap.closed);
  EXPECT_EQ(found.diagnosis.fitted.values, single.fitted.values);
  EXPECT_EQ(asked, 1);
  EXPECT_NE(found.decays_warning.find("is one decay"), std::string::npos);
  EXPECT_FALSE(found.blows);
}

TEST_F(StepByStep, AToneInTheReadingsIsAllowedForBeforeAnyEffectIsTried) {
  add_hum(0.02);
  const StepwiseDiagnosis found = by_steps();
  EXPECT_EQ(found.diagnosis.verdict, "no_gap");
  const auto hum = std::find_if(found.disturbances.begin(), found.disturbances.end(),
                                [](const Disturbance& d) { return d.kind == "foreign_tone"; });
  ASSERT_NE(hum, found.disturbances.end());
  EXPECT_EQ(hum->treated, "fitted");
  EXPECT_NEAR(*hum->frequency_hz, 7.3, 0.01);
  EXPECT_NEAR(hum->size, 0.02, 1e-3);
}

TEST_F(StepByStep, WhatTheModelLacksIsNotTakenForForeignContent) {
  withhold_drag();
  add_hum(0.02);
  const StepwiseDiagnosis found = by_steps();
  EXPECT_TRUE(found.diagnosis.gap.detected);
  EXPECT_FALSE(found.diagnosis.verdict == "no_gap");
}

}  // namespace
}  // namespace secular
