// What makes all records late alike may be a low-pass, which takes amplitude off, too.
#include "motion/correction/low_pass.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "generated/registry.hpp"
#include "jobs/identify/identification.hpp"
#include "tests/app/hardening_oscillator.hpp"
#include "tests/app/oscillator_estimate.hpp"
#include "tests/identification/virtual_campaign.hpp"

namespace secular {
namespace {

using testing_support::value_of;
using testing_support::warns;

// Fourteen dwells at two levels.
SimulatedCampaign filtered_dwells(std::uint64_t seed) {
  return testing_support::oscillator_campaign(testing_support::lopsided_oscillator() + R"([[dwell]]
frequencies_hz = [19.5, 19.75, 19.875, 20.0, 20.125, 20.25, 20.5]
amplitudes = [0.1, 0.3]
settle_s = 12.0
ensembles = 4
ensemble_s = 2.0
)",
                                              seed);
}

// A dwell of whole periods: what a filter or a delay makes of a channel is in its lines, those of the excitation's
// multiples that are above the noise.
void filter_lines(std::vector<double>& samples, double rate_hz, double frequency_hz, double pole_s,
                  double delay_s) {
  std::vector<double> change(samples.size(), 0.0);
  for (int n = 1; n <= 4; ++n) {
    const double w = 2 * std::numbers::pi * n * frequency_hz;
    std::complex<double> line = 0;
    for (std::size_t i = 0; i < samples.size(); ++i)
      line +=
          samples[i] * std::polar(2.0 / static_cast<double>(samples.size()), -w * static_cast<double>(i) / rate_hz);
    const std::complex<double> by = std::polar(1.0, -w * delay_s) / std::complex<double>(1, w * pole_s) - 1.0;
    for (std::size_t i = 0; i < samples.size(); ++i)
      change[i] += (line * by * std::polar(1.0, w * static_cast<double>(i) / rate_hz)).real();
  }
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] += change[i];
}

Identification identified_behind_filter(SimulatedCampaign made, std::size_t channel, double pole_s,
                                        double delay_s) {
  for (std::size_t r = 0; r < made.samples.size(); ++r)
    filter_lines(made.samples[r].channels[channel], 256, *made.campaign.records[r].excitation_frequency_hz, pole_s,
                 delay_s);
  return testing_support::identified_primary(made);
}

bool interval_holds(const EstimatedValue& value, double truth) {
  return std::abs(*value.value - truth) < 3 * value.sd;
}

// Amplitudes that are 0.7 % too small, on either side.
TEST(LowPass, OfASinglePoleIsAllowedFor) {
  const SimulatedCampaign made = filtered_dwells(11);
  for (const unsigned channel : {0U, 1U}) {
    const Identification id = identified_behind_filter(made, channel, 1 / (2 * std::numbers::pi * 170), 0);
    ASSERT_EQ(id.lateness.size(), 1U) << channel;
    EXPECT_TRUE(
        warns(id.estimate.warnings, channel == 0 ? "low-pass in the excitation" : "low-pass in the responses"));
    EXPECT_TRUE(interval_holds(value_of(id.estimate, "e"), 1))
        << channel << ", " << *value_of(id.estimate, "e").value;
    EXPECT_TRUE(interval_holds(value_of(id.estimate, "a3"), 2.5e8)) << channel;
    EXPECT_GT(std::abs(*value_of(id.estimate, "e").value - 1), 0.003) << channel;
  }
}

// Second harmonics tell a delay of the responses from a pole: of 0.5 rad, which is 1 rad there and not 0.83 rad.
TEST(LowPass, IsNotADelayThatHarmonicsTell) {
  const Identification id = identified_behind_filter(filtered_dwells(12), 1, 0, 0.004);
  ASSERT_EQ(id.lateness.size(), 1U);
  EXPECT_FALSE(warns(id.estimate.warnings, "a single pole"));
  EXPECT_TRUE(interval_holds(value_of(id.estimate, "e"), 1));
  EXPECT_LT(value_of(id.estimate, "e").sd, 0.01);  // a single pole would make 0.12 of it
}

CaseLateness lateness_of(const std::vector<double>& by_s) {
  CaseLateness result{"primary", PhaseFinding::late, {}, 0, 0, ""};
  for (std::size_t r = 0; r < by_s.size(); ++r) result.records.push_back({r, by_s[r], 0.05});
  return result;
}

ObservationSet at_20_hz(std::size_t records) {
  const CompiledModel& model = *generated::find_compiled_model("duffing");
  ObservationSet set;
  set.model = &model;
  set.resonance = &case_named(model, "primary");
  set.phase_unknown = true;
  for (std::size_t r = 0; r < records; ++r) {
    Observation o;
    o.record = r;
    o.excitation_frequency = {2 * std::numbers::pi * 20};
    o.amplitude = {1e-3};
    o.rate = {{0, 2 * std::numbers::pi * 20}};
    set.observations.push_back(o);
  }
  return set;
}

TEST(LowPass, IsWhatRecordsShare) {
  const std::vector<ObservationSet> sets = {at_20_hz(12)};
  for (const double by : {0.002, -0.002}) {
    std::vector<CaseLateness> same = {lateness_of(std::vector<double>(12, by))};
    const auto filter = shared_low_pass(same, sets);
    ASSERT_TRUE(filter);
    EXPECT_NEAR(filter->late_s, by, 1e-12);
    EXPECT_NEAR(filter->amplitude(), std::cos(2 * std::numbers::pi * 20 * 0.002), 1e-12);
    for (RecordLateness& record : same[0].records) record.late_s += 0.05;  // whole periods
    EXPECT_NEAR(shared_low_pass(same, sets)->late_s, by, 1e-12);
  }
  std::mt19937 draw(4);
  std::uniform_real_distribution<double> delays(0, 0.01);
  int told = 0;
  for (int i = 0; i < 200; ++i) {
    std::vector<double> by(12);
    for (double& l : by) l = delays(draw);
    told += shared_low_pass(std::vector{lateness_of(by)}, sets) ? 1 : 0;
  }
  EXPECT_LE(told, 4);  // one in 200 is expected
  EXPECT_FALSE(
      shared_low_pass(std::vector{lateness_of(std::vector<double>(12, 0.014))}, sets));  // above a quarter period
}

// What is put back makes lines of the motion before the poles, in the time of responses that are late.
TEST(LowPass, PutsBackWhatPolesTakeOff) {
  const double w = 2 * std::numbers::pi * 20;
  for (const int poles : {1, 4}) {
    ObservationSet set = at_20_hz(1);
    const EqualPoles filter{0.003, w, poles};
    const std::complex<double> by = std::pow(std::complex<double>(1, w * filter.time_constant()), poles);
    EXPECT_NEAR(std::arg(by), w * filter.late_s, 1e-12);
    EXPECT_NEAR(std::abs(by) * filter.amplitude(), 1, 1e-12);
    set.observations[0].amplitude[0] = std::complex<double>(1e-3, 2e-3) / by;
    set.observations[0].amplitude_sd = {1e-6};
    const ObservationSet before = before_poles(std::vector{set}, filter)[0];
    const std::complex<double> truth = std::complex<double>(1e-3, 2e-3) * std::polar(1.0, -w * filter.late_s);
    EXPECT_LT(std::abs(before.observations[0].amplitude[0] - truth), 1e-15);
    EXPECT_NEAR(before.observations[0].amplitude_sd[0], 1e-6 / filter.amplitude(), 1e-18);
  }
}

}  // namespace
}  // namespace secular
