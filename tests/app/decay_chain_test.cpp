// What a measuring chain does to free decays and dwells: harmonics, steps and drifts tell it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "jobs/identify/identification.hpp"
#include "measure/data/delayed_channels.hpp"
#include "tests/app/hardening_oscillator.hpp"
#include "tests/app/oscillator_estimate.hpp"
#include "tests/identification/virtual_campaign.hpp"

namespace secular {
namespace {

using testing_support::value_of;
using testing_support::warns;

constexpr double quadratic_of_decay = 4e5, cubic_of_decay = 2.5e8, rate_of_decay_hz = 512;

// Two decays of an oscillator of 20 Hz with a quadratic term.
SimulatedCampaign lopsided_decays(std::uint64_t seed) {
  std::string text = testing_support::lopsided_oscillator();
  text.replace(text.find("sample_rate_hz = 256.0"), 22, "sample_rate_hz = 512.0");
  return testing_support::oscillator_campaign(text + R"([[free_decay]]
initial_displacement = [0.002]
duration_s = 5.0
[[free_decay]]
initial_displacement = [0.0014]
duration_s = 5.0
)",
                                              seed);
}

using Chain = std::function<void(std::vector<double>& response, std::size_t record)>;

Identification identified_by_chain(SimulatedCampaign made, const Chain& chain) {
  for (std::size_t r = 0; r < made.samples.size(); ++r) chain(made.samples[r].channels[1], r);
  IdentificationRequest request;
  request.model = "duffing";
  request.resonances = {"free"};
  return identify_by_modulation(request, made.campaign, [&](std::size_t r) { return made.samples[r]; });
}

// A pole of which the samples are joined by straight lines.
void pass_pole(std::vector<double>& samples, double time_constant) {
  const double x = 1 / (rate_of_decay_hz * time_constant), stays = std::exp(-x), slope = 1 - (1 - stays) / x;
  double state = samples.front(), before = samples.front();
  for (double& y : samples) {
    state = stays * state + (1 - stays) * before + slope * (y - before);
    before = y;
    y = state;
  }
}

void pass_coupling(std::vector<double>& samples, double time_constant) {
  std::vector<double> slow = samples;
  slow.front() = 0;  // as if nothing had been there before
  pass_pole(slow, time_constant);
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] -= slow[i];
}

void expect_truth_or_doubt(const Identification& id) {
  for (const auto& [name, truth] : {std::pair{"a2", quadratic_of_decay}, std::pair{"a3", cubic_of_decay}}) {
    const EstimatedValue& value = value_of(id.estimate, name);
    ASSERT_TRUE(value.value);
    EXPECT_TRUE(value.doubtful || std::abs(*value.value - truth) < 3 * value.sd)
        << name << " " << *value.value << " " << value.sd;
  }
}

TEST(DecayChain, ThatIsGoodIsNotDoubted) {
  for (const std::uint64_t seed : {11U, 12U, 13U}) {
    const Identification id = identified_by_chain(lopsided_decays(seed), [](std::vector<double>&, std::size_t) {});
    EXPECT_FALSE(warns(id.estimate.warnings, "are not those that the model makes of it"));
    EXPECT_FALSE(warns(id.estimate.warnings, "the amplitude steps"));
    for (const char* name : {"omega0", "mu", "a2", "a3"})
      EXPECT_FALSE(value_of(id.estimate, name).doubtful) << name;
    EXPECT_LT(std::abs(*value_of(id.estimate, "a3").value - cubic_of_decay), 4 * value_of(id.estimate, "a3").sd);
  }
}

// A pole at three times the frequency: a3 is a tenth too large.
TEST(DecayChain, LowPassIsToldByHarmonics) {
  const Identification id = identified_by_chain(
      lopsided_decays(11), [](std::vector<double>& y, std::size_t) { pass_pole(y, 1 / (3 * 125.66)); });
  EXPECT_TRUE(warns(id.estimate.warnings, "low-pass of"));
  EXPECT_GT(*value_of(id.estimate, "a3").value / cubic_of_decay, 1.06);
  expect_truth_or_doubt(id);
}

// A corner at a fifth of the frequency takes 2 % off amplitudes, and turns harmonics against the motion.
TEST(DecayChain, HighPassIsToldByHarmonics) {
  const Identification id = identified_by_chain(
      lopsided_decays(11), [](std::vector<double>& y, std::size_t) { pass_coupling(y, 5 / 125.66); });
  EXPECT_TRUE(warns(id.estimate.warnings, "high-pass of"));
  EXPECT_GT(*value_of(id.estimate, "a3").value / cubic_of_decay, 1.02);
  expect_truth_or_doubt(id);
}

// Behind a coupling means are the smaller the faster it is, and have the other sign.
TEST(DecayChain, EvenLawBehindACouplingIsToldByMeans) {
  const SimulatedCampaign made = lopsided_decays(11);
  const double largest = testing_support::largest_response(made);
  for (const double share : {0.03, -0.06}) {
    const Identification id = identified_by_chain(made, [&](std::vector<double>& y, std::size_t) {
      for (double& sample : y) sample *= 1 + share * sample / largest;
      pass_coupling(y, 0.3);
    });
    EXPECT_TRUE(warns(id.estimate.warnings, "means show behind an AC coupling"));
    EXPECT_GT(std::abs(*value_of(id.estimate, "a2").value / quadratic_of_decay - 1), 0.1);
    expect_truth_or_doubt(id);
  }
}

// Harmonics show a coupling, and means an amplifier behind it.
TEST(DecayChain, EvenLawIsDoubtedBesideAHighPass) {
  const SimulatedCampaign made = lopsided_decays(11);
  const double largest = testing_support::largest_response(made);
  const Identification id = identified_by_chain(made, [&](std::vector<double>& y, std::size_t) {
    pass_coupling(y, 5 / 125.66);
    for (double& sample : y) sample *= 1 + 0.005 * sample / largest;
  });
  EXPECT_TRUE(warns(id.estimate.warnings, "high-pass of"));
  EXPECT_TRUE(warns(id.estimate.warnings, "which means show"));
  expect_truth_or_doubt(id);
  EXPECT_TRUE(value_of(id.estimate, "a2").doubtful);
}

TEST(DecayChain, EvenLawIsToldByMeans) {
  const SimulatedCampaign made = lopsided_decays(11);
  const double largest = testing_support::largest_response(made);
  for (const double share : {0.03, -0.06}) {
    const Identification id = identified_by_chain(made, [&](std::vector<double>& y, std::size_t) {
      for (double& sample : y) sample *= 1 + share * sample / largest;
    });
    EXPECT_TRUE(warns(id.estimate.warnings, "an even part of a sensor's law"));
    expect_truth_or_doubt(id);
  }
}

// A law y (1 + c y^2) falls with the square of the amplitude, which is a damping: 6 k |Y|^2 of the rate.
TEST(DecayChain, CubicLawIsTakenOffDampingToo) {
  const SimulatedCampaign made = lopsided_decays(11);
  const double largest = testing_support::largest_response(made);
  const Identification id = identified_by_chain(made, [&](std::vector<double>& y, std::size_t) {
    for (double& sample : y) sample *= 1 + 0.03 * sample * sample / (largest * largest);
  });
  EXPECT_TRUE(warns(id.estimate.warnings, "a cubic part of a sensor's law"));
  expect_truth_or_doubt(id);
  const EstimatedValue& mu = value_of(id.estimate, "mu");
  EXPECT_TRUE(mu.doubtful);
  EXPECT_LT(std::abs(*mu.value - 1), 3 * mu.sd);
  EXPECT_GT(mu.sd, 0.002);
  // The second harmonic grows with it, and a2 hardly moves: 6 k |Y|^2 of it would be two percent.
  const EstimatedValue& a2 = value_of(id.estimate, "a2");
  EXPECT_LT(std::abs(*a2.value - quadratic_of_decay), 3 * a2.sd);
}

// Zeros that wander, and couplings that pass no constant part, are no laws of a sensor.
TEST(DecayChain, ZerosAreNoLawsOfASensor) {
  const SimulatedCampaign made = lopsided_decays(11);
  const double largest = testing_support::largest_response(made);
  const std::function<double(double)> zeros[] = {[](double t) { return 0.005 * std::sin(0.6 * t); },
                                                 [](double t) { return 0.01 * std::exp(-t / 1.5); }};
  for (const auto& zero : zeros) {
    const Identification id = identified_by_chain(made, [&](std::vector<double>& y, std::size_t) {
      for (std::size_t i = 0; i < y.size(); ++i) y[i] += largest * zero(static_cast<double>(i) / rate_of_decay_hz);
    });
    EXPECT_FALSE(warns(id.estimate.warnings, "are not those that the model makes of it"));
    for (const char* name : {"omega0", "mu", "a2", "a3"})
      EXPECT_FALSE(value_of(id.estimate, name).doubtful) << name;
  }
}

TEST(DecayChain, StepOfTheSensitivityIsSeen) {
  const Identification id =
      identified_by_chain(lopsided_decays(12), [](std::vector<double>& y, std::size_t record) {
        if (record == 0)
          for (std::size_t i = 600; i < y.size(); ++i) y[i] *= 1.04;
      });
  EXPECT_TRUE(warns(id.estimate.warnings, "the amplitude steps by"));
  expect_truth_or_doubt(id);
}

// One decay of two by another sensitivity: the coefficients that both share scatter by as much.
TEST(DecayChain, RecordOfAnotherSensitivityWidensErrorBars) {
  for (const double gain : {1.05, 1 / 9.81})
    expect_truth_or_doubt(identified_by_chain(lopsided_decays(13), [&](std::vector<double>& y, std::size_t record) {
      if (record == 1)
        for (double& sample : y) sample *= gain;
    }));
}

// A sensitivity that grows by one percent along every dwell makes e half a percent too large.
TEST(DwellChain, DriftOfTheSensitivityIsAllowedFor) {
  const SimulatedCampaign made = testing_support::oscillator_campaign(
      testing_support::lopsided_oscillator() + testing_support::dwells_at_two_levels, 14);
  for (const double drift : {0.0, 0.008, -0.008}) {
    SimulatedCampaign changed = made;
    for (Record& record : changed.samples)
      for (std::size_t i = 0; i < record.samples(); ++i)
        record.channels[1][i] *= 1 + drift * static_cast<double>(i) / static_cast<double>(record.samples());
    const Identification id = testing_support::identified_primary(changed);
    EXPECT_EQ(warns(id.estimate.warnings, "along every dwell alike"), drift != 0) << drift;
    const EstimatedValue& e = value_of(id.estimate, "e");
    EXPECT_TRUE(e.doubtful || std::abs(*e.value - 1) < 3 * e.sd) << drift << ' ' << *e.value << ' ' << e.sd;
    EXPECT_TRUE(drift != 0 || !e.doubtful) << drift;
  }
}

// A common delay that is said is none that a filter may have made.
TEST(DwellChain, DelayThatIsSaidIsNotDoubted) {
  SimulatedCampaign late = testing_support::oscillator_campaign(
      testing_support::lopsided_oscillator() + testing_support::dwells_at_two_levels, 15);
  constexpr std::size_t rows = 1;  // 1/256 s
  for (Record& record : late.samples) {
    std::vector<double>&base = record.channels[0], &tip = record.channels[1];
    base.erase(base.begin(), base.begin() + rows);
    tip.erase(tip.end() - rows, tip.end());
  }
  EXPECT_TRUE(warns(testing_support::identified_primary(late).estimate.warnings, "late alike"));
  late.campaign.channels[1].delay_s = rows / late.campaign.sample_rate_hz;
  for (Record& record : late.samples) record = without_delays(late.campaign, record, "dwell");
  const Identification id = testing_support::identified_primary(late);
  EXPECT_FALSE(warns(id.estimate.warnings, "late alike"));
  for (const auto& [name, truth] : {std::pair{"a3", cubic_of_decay}, std::pair{"e", 1.0}}) {
    const EstimatedValue& value = value_of(id.estimate, name);
    EXPECT_FALSE(value.doubtful) << name;
    EXPECT_LT(std::abs(*value.value - truth), 4 * value.sd) << name;
  }
}

}  // namespace
}  // namespace secular
