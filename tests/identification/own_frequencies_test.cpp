// Dwells of a structure whose natural frequency differs from dwell to dwell, and of one that the model lacks a law
// of.
#include "motion/correction/own_frequencies.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <random>

#include "estimator/identification/unsupported_values.hpp"
#include "recovered_campaign.hpp"

namespace secular {
namespace {

using namespace testing_support;

class SlowOwnFrequencies : public testing::Test {
 protected:
  // (rate - i omega) B is what it is for a natural frequency that is higher by `higher`.
  static ObservationSet shifted(ObservationSet set, const std::function<double(const Observation&)>& higher) {
    for (Observation& o : set.observations) o.rate[0] -= std::complex<double>(0, higher(o));
    return set;
  }

  // As estimated without, and where natural frequencies differ.
  std::pair<CorrectedEstimate, CorrectedEstimate> estimated(ObservationSet set) {
    EstimateOptions options;
    options.threads = 2;
    const EstimateTask task{made.simulated.campaign,
                            {modal_projection(made.simulated.campaign, *made.model).unit, {"m/s^2"}},
                            options,
                            [](const char*) {}};
    sets = {std::move(set)};
    const CorrectedEstimate plain = estimate_corrected(sets, task);
    CorrectedEstimate found = plain;
    let_frequencies_differ(sets, task, found);
    return {plain, found};
  }

  double truth(const std::string& name) const {
    return truth_of(*made.model, *made.resonance, made.experiment.parameters, name);
  }

  const MadeCampaign made = make_campaign("principal_parametric", 3);
  const ObservationSet steady = observed(made.simulated, *made.model, *made.resonance);
  std::vector<ObservationSet> sets;
};

// Damping shares a factor with the strength of the excitation, which balances of frequency tell as well as scatter
// lets them: error bars are some five times as wide without its own noise in their rows. Within 5 sd: one campaign
// in a million.
TEST_F(SlowOwnFrequencies, OfEachDwellLeaveOtherNumbersSharper) {
  const double scatter = 1e-3 * truth("omega0");
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal(0, scatter);
  std::map<std::size_t, double> higher;
  const auto draw = [&](const Observation& o) {
    const auto [place, fresh] = higher.try_emplace(o.record, 0.0);
    if (fresh) place->second = normal(random);
    return place->second;
  };
  const auto [plain, found] = estimated(shifted(steady, draw));
  EXPECT_FALSE(cases_with_lack_of_fit(plain.estimate).empty());
  EXPECT_TRUE(cases_with_lack_of_fit(found.estimate).empty());
  for (const char* name : {"omega0", "mu1", "mu3"}) {
    const EstimatedValue& value = value_of(found.estimate, name);
    EXPECT_FALSE(value.doubtful) << name;
    EXPECT_NEAR(*value.value, truth(name), 5 * value.sd) << name;
  }
  EXPECT_LT(3 * value_of(found.estimate, "mu1").sd, value_of(plain.estimate, "mu1").sd);
  const auto& told = value_of(found.estimate, "omega0").between_records;
  ASSERT_TRUE(told);
  EXPECT_LE(told->low, scatter);
  EXPECT_GE(told->high, scatter);
}

// Frequencies that follow the amplitude are those of a law that the model lacks.
TEST_F(SlowOwnFrequencies, ThatFollowTheAmplitudeStayALackOfFit) {
  double largest = 0;
  for (const Observation& o : steady.observations) largest = std::max(largest, std::abs(o.amplitude[0]));
  const auto law = [&](const Observation& o) {
    return 3e-3 * truth("omega0") * std::pow(std::abs(o.amplitude[0]) / largest, 4);
  };
  const auto [plain, found] = estimated(shifted(steady, law));
  EXPECT_FALSE(cases_with_lack_of_fit(plain.estimate).empty());
  EXPECT_FALSE(cases_with_lack_of_fit(found.estimate).empty());
  EXPECT_TRUE(sets.front().frequency_scatter.empty());
}

}  // namespace
}  // namespace secular
