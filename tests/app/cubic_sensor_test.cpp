// Third harmonics that neither the model nor the excitation makes may come from a sensor whose amplitudes are
// wrong.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "generated/registry.hpp"
#include "jobs/identify/identification.hpp"
#include "motion/simulate/experiment.hpp"
#include "tests/app/hardening_oscillator.hpp"
#include "tests/app/oscillator_estimate.hpp"
#include "tests/identification/virtual_campaign.hpp"

namespace secular {
namespace {

using testing_support::value_of;
using testing_support::warns;

constexpr double strength_told = 1, hardening_told = 2.5e8;

SimulatedCampaign hardening_dwells(const std::string& shaker, std::uint64_t seed) {
  return testing_support::oscillator_campaign(
      testing_support::hardening_oscillator + shaker + testing_support::dwells_at_two_levels, seed);
}

Identification identified(SimulatedCampaign made, const std::function<double(double)>& sensor) {
  for (Record& record : made.samples)
    std::ranges::transform(record.channels[1], record.channels[1].begin(), sensor);
  return testing_support::identified_primary(made);
}

bool holds(const EstimatedValue& value, double truth) {
  return std::abs(*value.value - truth) < 3 * value.sd;
}

// As an amplifier that saturates softly: 3 % of third harmonic at the largest motion, and a gain that is 9 % low
// there.
TEST(CubicSensor, IsAllowedForInWhatAmplitudesTell) {
  const SimulatedCampaign made = hardening_dwells("", 11);
  const double largest = testing_support::largest_response(made);
  const Identification id = identified(made, [&](double y) { return y * (1 - 0.12 * std::pow(y / largest, 2)); });
  EXPECT_TRUE(warns(id.estimate.warnings, "a sensor which is not linear"));
  EXPECT_TRUE(holds(value_of(id.estimate, "e"), strength_told)) << *value_of(id.estimate, "e").value;
  EXPECT_TRUE(holds(value_of(id.estimate, "a3"), hardening_told)) << *value_of(id.estimate, "a3").value;
  EXPECT_TRUE(value_of(id.estimate, "e").doubtful);
}

// A shaker's harmonics are measured, and what they make of the response is no excess.
TEST(CubicSensor, IsNotTheShaker) {
  for (const char* shaker : {"", "[shaker]\nharmonics = [0.05, 0.05]\n"}) {
    const Identification id = identified(hardening_dwells(shaker, 12), [](double y) { return y; });
    EXPECT_FALSE(warns(id.estimate.warnings, "a sensor which is not linear")) << shaker;
    EXPECT_LT(value_of(id.estimate, "e").sd, 0.002) << shaker;
  }
}

// Mains at three times the excitation is in no phase with the motion and does not grow with it.
TEST(CubicSensor, IsNotMainsHum) {
  SimulatedCampaign made = hardening_dwells("", 13);
  for (std::size_t r = 0; r < made.samples.size(); ++r) {
    std::vector<double>& tip = made.samples[r].channels[1];
    for (std::size_t i = 0; i < tip.size(); ++i)
      tip[i] += 0.3 * std::cos(2 * std::numbers::pi * 60 * static_cast<double>(i) / 256 + static_cast<double>(r));
  }
  const Identification id = identified(std::move(made), [](double y) { return y; });
  EXPECT_FALSE(warns(id.estimate.warnings, "a sensor which is not linear"));
  EXPECT_TRUE(holds(value_of(id.estimate, "e"), strength_told));
  EXPECT_LT(value_of(id.estimate, "e").sd, 0.004);
}

// What a campaign leaves open moves the predicted harmonics: that is no excess.
TEST(SlowCubicSensor, IsNotWhatACampaignLeavesOpen) {
  const auto file = testing_support::source_folder() / "models/experiments/principal_parametric.toml";
  const CompiledModel& model = *generated::find_compiled_model("two_mass_mode1");
  const SimulatedCampaign made = run_virtual_test(read_experiment(file, model), model, 3, 2);
  IdentificationRequest request;
  request.model = "two_mass_mode1";
  const Identification id =
      identify_by_modulation(request, made.campaign, [&](std::size_t r) { return made.samples[r]; });
  EXPECT_FALSE(warns(id.estimate.warnings, "a sensor which is not linear"));
  EXPECT_FALSE(value_of(id.estimate, "eta1").doubtful);
  EXPECT_FALSE(value_of(id.estimate, "mu3").doubtful);
}

}  // namespace
}  // namespace secular
