// Which estimate of a campaign counts: with phases as measured, or as unknowns.
#include "motion/correction/free_phases.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "recovered_campaign.hpp"

namespace secular {
namespace {

using namespace testing_support;

class SlowFreePhases : public testing::Test {
 protected:
  PhasedEstimate estimated(const ObservationSet& set) {
    stages.clear();
    EstimateOptions options;
    options.threads = 2;
    return estimate_with_phases({set}, {made.simulated.campaign,
                                        {modal_projection(made.simulated.campaign, *made.model).unit, {"m/s^2"}},
                                        options,
                                        [this](const char* stage) { stages.emplace_back(stage); }});
  }

  // The excitation looks ahead of responses that are late, in each record by another time.
  ObservationSet late() const {
    ObservationSet set = in_step;
    for (Observation& o : set.observations)
      for (std::size_t j = 0; j < o.forcing.size(); ++j)
        o.forcing[j] *= std::polar(1.0, 0.7 * static_cast<double>((7 * o.record) % 5));
    return set;
  }

  void expect_truth(const Estimate& found, const std::string& name) const {
    const EstimatedValue& value = value_of(found, name);
    ASSERT_TRUE(value.value) << name;
    EXPECT_NEAR(*value.value, truth_of(*made.model, *made.resonance, made.experiment.parameters, name),
                5 * value.sd)
        << name;
  }

  const MadeCampaign made = make_campaign("principal_parametric", 3);
  const ObservationSet in_step = observed(made.simulated, *made.model, *made.resonance);
  std::vector<std::string> stages;
};

TEST_F(SlowFreePhases, OfRecordsInStepThePhasesStayAsMeasured) {
  const PhasedEstimate found = estimated(in_step);
  EXPECT_TRUE(found.lateness.empty());
  EXPECT_TRUE(found.freed.empty());
  ASSERT_EQ(found.of.measured.size(), 1U);
  EXPECT_FALSE(found.of.measured.front().phase_unknown);
  EXPECT_FALSE(found.of.corrected.empty());
  ASSERT_FALSE(stages.empty());
  EXPECT_EQ(stages.front(), "regression");
  expect_truth(found.of.estimate, "omega0");
}

TEST_F(SlowFreePhases, RecordsThatAreLateTellTheirNumbersWithPhasesAsUnknowns) {
  const PhasedEstimate found = estimated(late());
  ASSERT_EQ(found.lateness.size(), 1U);
  EXPECT_EQ(found.lateness.front().finding, PhaseFinding::late);
  EXPECT_EQ(found.freed.size(), 1U);
  EXPECT_TRUE(found.of.measured.front().phase_unknown);
  for (const char* name : {"omega0", "mu1"}) expect_truth(found.of.estimate, name);
}

}  // namespace
}  // namespace secular
