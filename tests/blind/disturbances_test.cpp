// What the blind check's disturbances do to records, against what their sizes say.
#include "blind/disturbances.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "blind/sealed_campaign.hpp"
#include "blind/sealed_files.hpp"
#include "blind/signature.hpp"
#include "tests/process_folder.hpp"

namespace secular::blind {
namespace {

namespace fs = std::filesystem;

// Amplitude at a frequency, by the finite Fourier sum.
std::complex<double> line(const std::vector<double>& x, double hz) {
  std::complex<double> sum;
  for (std::size_t i = 0; i < x.size(); ++i)
    sum += x[i] * std::polar(1.0, -two_pi * hz * static_cast<double>(i) / sample_rate_hz);
  return 2.0 * sum / static_cast<double>(x.size());
}

TEST(BlindDisturbances, ColouredNoiseHasTheDensityThatCountsAsItsNoise) {
  Disturbances d;
  d.coloured = {0.5};
  d.correlation_s = 0.05;
  constexpr std::size_t samples = 256, draws = 4000;
  Random random(3, 1);
  for (const double hz : {2.0, 8.0, 40.0}) {
    double squares = 0;
    for (std::size_t n = 0; n < draws; ++n) {
      std::vector<std::vector<double>> channels = {std::vector<double>(samples)};
      disturb_samples(d, random, channels);
      squares += std::norm(line(channels[0], hz)) / draws;
    }
    // White noise of standard deviation s gives E|line|^2 = 4 s^2/samples; what leaks from low frequencies into
    // 5 correlation times is of the order of 1/5 beyond the corner, so the record is long beside it.
    const double white = d.coloured_as_white(0, hz);
    EXPECT_NEAR(squares, 4 * white * white / samples, 0.15 * squares) << hz;
  }
}

TEST(BlindDisturbances, ToneRingingAndStepsHaveTheirSizes) {
  Disturbances d;
  d.hum = {0.2, 0.1};
  d.ringing = {0, 0.3};
  d.ringing_hz = 31;
  d.ringing_rate = 0.5;
  d.step = {0.01, 0.02};
  std::vector<std::vector<double>> channels(2, std::vector<double>(1024));
  Random random(3, 2);
  disturb_samples(d, random, channels);
  EXPECT_NEAR(std::abs(line(channels[0], 50)), 0.2, 1e-9);
  EXPECT_NEAR(std::abs(line(channels[0], 106)), 0.2 / 3, 1e-9);  // 150 Hz, seen at 256 - 150
  // Mean of exp(-t/2) over 4 s: (1 - exp(-2))/2. The tone of 50 Hz has whole periods; the ringing's image is small.
  EXPECT_NEAR(std::abs(line(channels[1], 31)), 0.3 * (1 - std::exp(-2.0)) / 2, 2e-3);
  EXPECT_LT(std::abs(line(channels[0], 31)), 1e-9);
  convert_samples(d, random, channels);
  for (const double x : channels[1]) EXPECT_NEAR(x / 0.02, std::round(x / 0.02), 1e-9);
}

TEST(BlindDisturbances, HeldAndLostSamplesAreAsManyAsTheySay) {
  Disturbances d;
  d.held_share = 0.01;
  d.lost_per_record = 5;
  std::vector<std::vector<double>> channels(1, std::vector<double>(100000));
  for (std::size_t i = 0; i < channels[0].size(); ++i) channels[0][i] = static_cast<double>(i);
  Random random(3, 3);
  convert_samples(d, random, channels);
  double held = 0;
  for (std::size_t i = 1; i < channels[0].size(); ++i) held += channels[0][i] == channels[0][i - 1];
  EXPECT_NEAR(held, 1000, 5 * std::sqrt(1000.0));
  const std::vector<std::size_t> lost = lost_rows(d, 4096, random);
  EXPECT_LE(lost.size(), 5U);
  EXPECT_GE(lost.front(), 1U);
  EXPECT_LT(lost.back(), 4095U);
}

// Every kind comes about as often as any other, one to three at once, and nothing that was not drawn acts.
TEST(BlindDisturbances, EveryKindIsDrawn) {
  const DisturbedCampaign campaign{{1, 1}, {2, 2}, 10, 12};
  std::map<std::string, int> times;
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    Random random(seed, 9);
    const Disturbances d = draw_disturbances(campaign, random);
    ASSERT_GE(d.kinds.size(), 1U);
    ASSERT_LE(d.kinds.size(), 3U);
    for (const std::string& kind : d.kinds) ++times[kind];
    const bool by_record = d.latest_s > 0 || d.frequency_scatter > 0;
    EXPECT_EQ(d.records.size(), by_record ? 12U : 0U);
  }
  ASSERT_EQ(times.size(), disturbance_kinds().size());
  // 600 campaigns with two kinds of ten in the mean.
  for (const auto& [kind, count] : times) EXPECT_NEAR(count, 120, 5 * std::sqrt(120.0)) << kind;
}

CampaignPlan small_plan(bool disturbed) {
  return {.number = 3,
          .kind = "single",
          .effects = {"quintic_stiffness"},
          .family = "primary",
          .snr_db = 40,
          .dwells = 6,
          .disturbed = disturbed};
}

// Structure, effect and model file are those of the seed; the strength is counted in the noise that is there.
TEST(BlindDisturbances, LeaveStructureAndEffectAsTheyWere) {
  const fs::path folder = testing_support::process_folder() / "blind_disturbances";
  for (const bool disturbed : {false, true}) {
    const fs::path place = folder / (disturbed ? "disturbed" : "clean");
    const SealedCampaign sealed = draw_campaign(small_plan(disturbed), 8);
    write_sealed(sealed, 8, place);
    write_text(place / "label.json", label_of(sealed).dump());
  }
  const auto label = [&](const char* name) {
    return nlohmann::json::parse(read_text(folder / name / "label.json"));
  };
  EXPECT_EQ(read_text(folder / "clean/model.toml"), read_text(folder / "disturbed/model.toml"));
  EXPECT_EQ(label("clean")["effects"][0]["effect"], label("disturbed")["effects"][0]["effect"]);
  EXPECT_FALSE(label("clean").contains("disturbances"));
  EXPECT_GE(label("disturbed")["disturbances"].size(), 1U);
  EXPECT_NE(read_text(folder / "clean/campaign/records/0001.csv"),
            read_text(folder / "disturbed/campaign/records/0001.csv"));
  fs::remove_all(folder);
}

// What scatters from record to record hides an effect: of a frequency that scatters by sd, an effect that moves it
// alone keeps no more than its shift over sd, in six ensembles as in one.
TEST(BlindDisturbances, ScatterCountsAsNoise) {
  Random random(11, 4);
  Specimen specimen =
      draw_specimen("primary", {"cubic_stiffness", "quadratic_damping", "cubic_damping"}, 4, random);
  Disturbances d;
  d.frequency_scatter = 2e-3;
  const std::vector<double> noise(specimen.measurement.names.size(), 1e-6);
  const Signatures scattering(specimen, noise, d), clean(specimen, noise);
  Reality reality = reality_of(specimen);
  reality.structure.mode[0].omega *= 1 + 1e-4;
  const double strength = scattering.strength(scattering.change(reality, false), false);
  EXPECT_NEAR(strength * std::sqrt(static_cast<double>(ensembles_per_dwell)), 1e-4 / 2e-3, 0.05 * 1e-4 / 2e-3);
  EXPECT_GT(clean.strength(clean.change(reality, false), false), 1);
}

// Responses that are late by tau: the phase of the response's line behind the excitation's grows by Omega tau.
TEST(BlindDisturbances, LateRecordsAreLate) {
  SealedCampaign sealed = draw_campaign(small_plan(false), 8);
  const fs::path folder = testing_support::process_folder() / "blind_late";
  const Dwell& dwell = sealed.specimen.dwells.front();
  const double hz = dwell.drive.frequency / two_pi;
  const auto phase_behind = [&](const char* name) {
    write_sealed(sealed, 8, folder / name);
    std::istringstream text(read_text(folder / name / "campaign/records/0001.csv"));
    std::string row;
    std::getline(text, row);
    std::vector<double> base, response;
    while (std::getline(text, row)) {
      const std::size_t first = row.find(','), second = row.find(',', first + 1);
      base.push_back(std::stod(row.substr(first + 1)));
      response.push_back(std::stod(row.substr(second + 1)));
    }
    return std::arg(line(base, hz) / line(response, hz));
  };
  const double before = phase_behind("in_time");
  sealed.disturbances.records.assign(sealed.motions.size() + sealed.of_stretches.size(), {1, 0.004});
  const double turned = phase_behind("late") - before;
  EXPECT_NEAR(std::remainder(turned - dwell.drive.frequency * 0.004, two_pi), 0, 0.02);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace secular::blind
