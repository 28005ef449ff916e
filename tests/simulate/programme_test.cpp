#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "generated/registry.hpp"
#include "input/input_error.hpp"
#include "motion/simulate/excitation_signal.hpp"
#include "motion/simulate/experiment.hpp"
#include "motion/simulate/sensor_fault.hpp"
#include "tests/process_folder.hpp"
#include "tests/simulate/simulated_campaign.hpp"

namespace secular {
namespace {

std::string experiment_text(const std::string& programme) {
  return R"(schema = 1
name = "programme"
model = "two_mass_mode1"
sample_rate_hz = 256.0
[parameters]
omega0 = 77.85
mu1 = 0.8
mu2 = 0.0
mu3 = 0.0
alpha2 = 0.0
alpha3 = 0.0
delta2 = 0.0
delta3 = 0.0
eta1 = -0.5
eta2 = 0.0
[excitation]
name = "base"
quantity = "acceleration"
[[response]]
name = "v"
quantity = "displacement"
)" + programme;
}

SimulatedCampaign simulated(const std::string& programme) {
  const std::filesystem::path path = testing_support::process_folder() / "programme.toml";
  std::ofstream(path) << experiment_text(programme);
  const CompiledModel& model = *generated::find_compiled_model("two_mass_mode1");
  const Experiment experiment = read_experiment(path, model);
  return run_virtual_test(experiment, model, 1, 1);
}

// The derivatives that a signal hands out are those of its value.
TEST(ExcitationSignals, DerivativesBelongToTheValue) {
  for (const ExcitationSignal& signal : {harmonic_wave(20, 1.5, 0.3, {0.1, -0.05}), linear_sweep(5, 0.7, 2, {0.2}),
                                         half_sine_pulse(3, 0.1, 2.0), random_phase_multisine(1, 9, 40, 1.0, 7)}) {
    const double t = 0.7, h = 1e-5;
    ExcitationSample before, here, after;
    signal(t - h, &before);
    signal(t, &here);
    signal(t + h, &after);
    EXPECT_NEAR((after.value - before.value) / (2 * h), here.first_derivative,
                1e-6 * (1 + std::abs(here.second_derivative)));
    EXPECT_NEAR((after.first_derivative - before.first_derivative) / (2 * h), here.second_derivative,
                1e-4 * (1 + std::abs(here.second_derivative)));
  }
}

TEST(ExcitationSignals, MultisineHasItsPower) {
  const ExcitationSignal signal = random_phase_multisine(10, 20, 101, 0.7, 3);  // lines 0.1 Hz apart: period 10 s
  double square = 0;
  ExcitationSample sample;
  for (int i = 0; i < 10000; ++i) {
    signal(1e-3 * i, &sample);
    square += sample.value * sample.value / 10000;
  }
  EXPECT_NEAR(std::sqrt(square), 0.7, 1e-10);
}

// A short pulse on a linear oscillator gives it the velocity eta1 * (2/pi) * peak * width; then it rings down.
TEST(Programmes, ImpactGivesItsMomentum) {
  const SimulatedCampaign c = simulated("[[impact]]\npeak = 100\nat_s = 0.05\nwidth_s = 0.001\nduration_s = 1.0\n");
  ASSERT_EQ(c.samples.size(), 1U);
  EXPECT_EQ(c.campaign.records[0].kind, RecordKind::impact);
  const double speed = -0.5 * 2 / std::numbers::pi * 100 * 0.001, mu = 0.8, w = std::sqrt(77.85 * 77.85 - mu * mu);
  for (const std::size_t i : {40U, 100U, 200U}) {
    const double t = static_cast<double>(i) / 256 - 0.0505;  // since the middle of the pulse
    EXPECT_NEAR(c.samples[0].channels[1][i], speed / w * std::exp(-mu * t) * std::sin(w * t),
                2e-3 * std::abs(speed / w));
  }
}

TEST(Programmes, SweepFollowsItsFrequencyAndPassesResonance) {
  const SimulatedCampaign c =
      simulated("[[sweep]]\nfrom_hz = 11\nto_hz = 14\nrate_hz_per_s = 0.1\namplitude = 1.0\nsettle_s = 10\n");
  EXPECT_EQ(c.campaign.records[0].kind, RecordKind::sweep);
  const std::vector<double>& v = c.samples[0].channels[1];
  ASSERT_EQ(v.size(), 7681U);
  const auto largest = std::max_element(v.begin(), v.end()) - v.begin();
  const double at_hz = 11 + 0.1 * static_cast<double>(largest) / 256;
  // The largest response lags behind the resonance by about the time constant 1/mu times the rate.
  EXPECT_GT(at_hz, 77.85 / (2 * std::numbers::pi));
  EXPECT_LT(at_hz, 77.85 / (2 * std::numbers::pi) + 2 * 0.1 / 0.8);
  // Steady at the start: the amplitude of the first period is the static response at 11 Hz.
  const double omega = 2 * std::numbers::pi * 11, start = 0.5 / std::abs(77.85 * 77.85 - omega * omega);
  EXPECT_NEAR(*std::max_element(v.begin(), v.begin() + 24), start, 0.03 * start);
}

TEST(Programmes, BroadbandAndShakerHarmonics) {
  const SimulatedCampaign c = simulated(
      "[[broadband]]\nlow_hz = 5\nhigh_hz = 30\nlines = 50\nrms = 2.0\nduration_s = 4\n"
      "[[dwell]]\nfrequencies_hz = [10.0]\namplitudes = [1.0]\nensemble_s = 1.0\nsettle_s = "
      "1.0\n[shaker]\nharmonics = "
      "[0.25]\n");
  EXPECT_EQ(c.campaign.records[1].kind, RecordKind::broadband);
  // The dwell's base motion holds a quarter of its amplitude at twice the frequency: at its start 1 + 0.25.
  EXPECT_NEAR(*std::max_element(c.samples[0].channels[0].begin(), c.samples[0].channels[0].end()), 1.25, 1e-3);
}

TEST(SensorFaults, DoWhatTheirNamesSay) {
  Record clean;
  clean.sample_rate_hz = 256;
  clean.channels.assign(2, std::vector<double>(400));
  const auto base = [](double t) { return std::sin(30 * t); };
  const auto response = [](double t) { return 0.5 * std::cos(40 * t + 0.2); };
  for (std::size_t i = 0; i < 400; ++i) {
    clean.channels[0][i] = base(static_cast<double>(i) / 256);
    clean.channels[1][i] = response(static_cast<double>(i) / 256);
  }
  using enum ChannelFault;
  Record r = clean;
  apply_sensor_faults({{gain, "v", 1.1}, {offset, "v", 0.01}, {cross_axis, "v", 0.2}}, {"base", "v"}, true, r);
  EXPECT_NEAR(r.channels[1][77], 1.1 * clean.channels[1][77] + 0.01 + 0.2 * clean.channels[0][77], 1e-15);
  EXPECT_EQ(r.channels[0], clean.channels[0]);
  r = clean;
  apply_sensor_faults({{skew, "v", 0.0137}}, {"base", "v"}, true, r);
  for (std::size_t i = 60; i < 340; i += 31)
    EXPECT_NEAR(r.channels[1][i], response(static_cast<double>(i) / 256 - 0.0137), 2e-4);
  clip({{clipping, "v", 0.3}}, "v", r.channels[1]);
  EXPECT_EQ(*std::max_element(r.channels[1].begin(), r.channels[1].end()), 0.3);
}

TEST(Programmes, BadInputIsRefused) {
  for (const char* programme : {"[[sweep]]\nfrom_hz = 11\nto_hz = 11\nrate_hz_per_s = 1\namplitude = 1\n",
                                "[[sweep]]\nfrom_hz = 11\nto_hz = 400\nrate_hz_per_s = 1\namplitude = 1\n",
                                "[[broadband]]\nlow_hz = 20\nhigh_hz = 10\nrms = 1\nduration_s = 1\n",
                                "[[impact]]\npeak = 1\nwidth_s = 0\nduration_s = 1\n",
                                "[[impact]]\npeak = 1\nwidth_s = 0.01\nduration_s = 1\n[[fault]]\neffect = "
                                "\"rust\"\nchannel = \"v\"\nstrength = 1\n",
                                "[[impact]]\npeak = 1\nwidth_s = 0.01\nduration_s = 1\n[[fault]]\neffect = "
                                "\"clipping\"\nchannel = \"w\"\nstrength = "
                                "1\n"})
    EXPECT_THROW(simulated(programme), InputError) << programme;
}

}  // namespace
}  // namespace secular
