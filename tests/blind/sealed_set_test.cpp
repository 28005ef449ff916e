// Drawing, sealing and writing a set.
#include "blind/sealed_set.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "blind/random.hpp"
#include "blind/sealed_files.hpp"
#include "blind/sha256.hpp"
#include "blind/signature.hpp"
#include "input/input_error.hpp"
#include "tests/process_folder.hpp"

namespace secular::blind {
namespace {

namespace fs = std::filesystem;

class BlindFolder : public testing::Test {
 protected:
  void SetUp() override {
    folder = testing_support::process_folder() /
             ("secular_blind_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }
  fs::path folder;
};

std::map<std::string, std::string> files_in(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files[fs::relative(entry.path(), folder).string()] = read_text(entry.path());
  return files;
}

// FIPS 180-4, examples of the appendix and the empty message.
TEST(BlindSha256, IsTheStandards) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

TEST(BlindRandom, GaussianHasItsMoments) {
  Random random(5, 7);
  constexpr int n = 20000;
  double sum = 0, squares = 0, fourth = 0;
  for (int i = 0; i < n; ++i) {
    const double x = random.gaussian();
    sum += x;
    squares += x * x;
    fourth += x * x * x * x;
  }
  // Five standard errors: 1/sqrt(n), sqrt(2/n), sqrt(96/n).
  EXPECT_NEAR(sum / n, 0, 5 / std::sqrt(n));
  EXPECT_NEAR(squares / n, 1, 5 * std::sqrt(2.0 / n));
  EXPECT_NEAR(fourth / n, 3, 5 * std::sqrt(96.0 / n));
  Random same(5, 7), other(5, 8);
  EXPECT_EQ(Random(5, 7).gaussian(), same.gaussian());
  EXPECT_NE(Random(5, 7).gaussian(), other.gaussian());
}

TEST(BlindPlans, EveryEffectIsDrawnAndKindsKeepTheirShares) {
  const std::vector<CampaignPlan> plans = draw_plans({.campaigns = 400, .seed = 3, .size = SetSize::full_set});
  std::map<std::string, int> kinds;
  std::set<std::string> effects;
  std::set<double> noise;
  for (const CampaignPlan& plan : plans) {
    ++kinds[plan.kind];
    noise.insert(plan.snr_db);
    if (plan.kind == "single") effects.insert(plan.effects.begin(), plan.effects.end());
    EXPECT_FALSE(plan.family.empty());
  }
  EXPECT_EQ(kinds["none"], 60);
  EXPECT_EQ(kinds["single"], 220);
  EXPECT_EQ(kinds["pair"], 40);
  EXPECT_EQ(kinds["outside"], 60);
  EXPECT_EQ(kinds["parameters"], 20);
  EXPECT_EQ(noise, (std::set<double>{10, 20, 30, 40}));
  // All of the catalogue that the generator can make but `parameters`, which is a kind of its own: level_stiffness,
  // stops, the spring that levels off, falling friction and a power of the speed among them.
  EXPECT_EQ(effects.size(), 34u);
}

// A coefficient's step of a strength that is known: linear response q = eta1 F H, so 1 % more eta1 is 1 % more q,
// and so is an excitation of 1 % more, which its channel's noise leaves open.
TEST(BlindSignature, CountsStandardDeviationsOfAnEnsemble) {
  Random random(11, 4);
  Specimen specimen =
      draw_specimen("primary", {"cubic_stiffness", "quadratic_damping", "cubic_damping"}, 4, random);
  specimen.dwells.resize(2);
  const double sd = 1e-3;
  const Signatures signatures(specimen, std::vector<double>(specimen.measurement.names.size(), sd));
  Reality reality = reality_of(specimen);
  reality.structure.mode[0].direct *= 1.01;
  const Eigen::VectorXd change = signatures.change(reality, false);
  const double sd_of_amplitude = sd * std::sqrt(2 / static_cast<double>(ensemble_samples));
  double squares = 0;
  for (const Dwell& dwell : specimen.dwells) {
    const Motion motion = recorded_motion(specimen.structure, dwell.drive, dwell.state, 4096, 4);
    const auto channels = measured(specimen.measurement, dwell.drive, motion, true);
    double response = 0;  // squared amplitudes, in standard deviations
    for (std::size_t c = 1; c < channels.size(); ++c) {
      double mean_square = 0;
      for (const double x : channels[c]) mean_square += x * x / 4096;
      response += 2 * mean_square / (sd_of_amplitude * sd_of_amplitude);
    }
    const double excitation = std::pow(dwell.drive.amplitude / sd_of_amplitude, 2);
    squares += std::pow(0.01, 2) * response / (1 + response / excitation);
  }
  EXPECT_NEAR(signatures.strength(change, false), std::sqrt(squares / 2), 0.01 * std::sqrt(squares / 2));
  // The model's own parameters take it up.
  EXPECT_LT(signatures.unexplained(change, false).norm(), 1e-3 * change.norm());
}

// Numbers of the model's own that have moved far: the first step of a fit does not get there.
TEST(BlindSignature, OwnParametersAreFittedToConvergence) {
  Random random(11, 4);
  Specimen specimen =
      draw_specimen("primary", {"cubic_stiffness", "quadratic_damping", "cubic_damping"}, 20, random);
  const Signatures signatures(specimen, std::vector<double>(specimen.measurement.names.size(), 1e-3));
  Reality reality = reality_of(specimen);
  ModeTerms& mode = reality.structure.mode[0];
  mode.mu1 *= 1.4;
  mode.omega += 0.7 * specimen.decay_rate[0];
  mode.direct *= 1.2;
  const Eigen::VectorXd change = signatures.change(reality, false);
  ASSERT_TRUE(change.allFinite());
  EXPECT_GT(signatures.linear_unexplained(change, false).norm(), 0.1 * change.norm());
  EXPECT_LT(signatures.refitted_unexplained(change, false).norm(), 0.01 * change.norm());
}

// Changes that do not add up: a spring and the model's own parameters together lead to the truth that was made of
// them, whatever the spring's size at first.
TEST(BlindSignature, ARivalIsFittedTogetherWithTheModelsOwnParameters) {
  Random random(11, 4);
  Specimen specimen =
      draw_specimen("primary", {"cubic_stiffness", "quadratic_damping", "cubic_damping"}, 20, random);
  const Signatures signatures(specimen, std::vector<double>(specimen.measurement.names.size(), 1e-3));
  const double cubic = coefficient_of_share(specimen, "cubic_stiffness", 0, 1);
  const auto with_spring = [&](double coefficient) {
    Reality reality = reality_of(specimen);
    reality.structure.mode[0].alpha3 += coefficient;
    return reality;
  };
  Reality reality = with_spring(cubic);
  reality.structure.mode[0].mu1 *= 1.3;
  reality.structure.mode[0].omega += 0.5 * specimen.decay_rate[0];
  const Eigen::VectorXd change = signatures.change(reality, false);
  ASSERT_TRUE(change.allFinite());
  EXPECT_GT(signatures.refitted_unexplained(change, false).norm(), 0.1 * change.norm());
  EXPECT_LT(signatures.refitted_unexplained(change, false, with_spring, 0.4 * cubic).norm(), 0.01 * change.norm());
}

// White noise in a response has unit variance in every coefficient, so that the spectra of two channels of samples
// have the squares of the samples in units of it: 1 % more excitation is 1 % more of a linear response.
TEST(BlindSignature, StretchesCountStandardDeviationsOfSamples) {
  for (const Programme programme : {Programme::sweeps, Programme::broadband, Programme::impacts}) {
    Random random(11, 4);
    const Specimen specimen =
        draw_specimen("primary", {"cubic_stiffness", "quadratic_damping", "cubic_damping"}, 0, random, programme);
    ASSERT_FALSE(specimen.stretches.empty());
    std::vector<double> noise(specimen.measurement.names.size(), 1e-3);
    noise[0] = 0;  // of the excitation
    const Signatures signatures(specimen, noise);
    Reality reality = reality_of(specimen);
    reality.structure.mode[0].direct *= 1.01;
    double squares = 0, ensembles = 0;
    for (const Stretch& stretch : specimen.stretches) {
      const Motion motion = recorded_motion(specimen.structure, stretch.drive, stretch.state, stretch.samples, 4);
      const auto channels = measured(specimen.measurement, stretch.drive, motion, true);
      for (std::size_t c = 1; c < channels.size(); ++c)
        for (const double x : channels[c]) squares += std::pow(0.01 * x / 1e-3, 2);
      ensembles += static_cast<double>(stretch.samples) / static_cast<double>(ensemble_samples);
    }
    const Eigen::VectorXd change = signatures.change(reality, false);
    EXPECT_NEAR(signatures.strength(change, false), std::sqrt(squares / ensembles),
                1e-3 * std::sqrt(squares / ensembles))
        << name_of(programme);
    EXPECT_LT(signatures.unexplained(change, false).norm(), 1e-3 * change.norm()) << name_of(programme);
    // Where the reading of the excitation is noisy, what it makes in the response is noise as well.
    noise[0] = 1;
    EXPECT_LT(Signatures(specimen, noise).change(reality, false).norm(), 0.9 * change.norm()) << name_of(programme);
  }
}

// How a decay begins is nothing that a model knows.
TEST(BlindSignature, BeginsOfDecaysExplainNothing) {
  Random random(12, 4);
  const Specimen specimen = draw_specimen("primary", {"cubic_stiffness"}, 0, random, Programme::decays);
  const Signatures signatures(specimen, std::vector<double>(specimen.measurement.names.size(), 1e-3));
  Reality reality = reality_of(specimen);
  reality.begun.resize(specimen.stretches.size());
  displacement(reality.begun[1], 0) = 0.01 * specimen.typical_amplitude[0];
  const Eigen::VectorXd change = signatures.change(reality, false);
  EXPECT_GT(change.norm(), 1);
  EXPECT_LT(signatures.refitted_unexplained(change, false).norm(), 0.01 * change.norm());
}

// Files of every programme are read as what they are, and its folder is made anew byte for byte.
TEST_F(BlindFolder, RecordsOfEveryProgrammeAreNamedInTheCampaign) {
  const std::map<Programme, std::string> kinds = {{Programme::decays, "free_decay"},
                                                  {Programme::one_decay, "free_decay"},
                                                  {Programme::sweeps, "sweep"},
                                                  {Programme::broadband, "broadband"},
                                                  {Programme::impacts, "impact"}};
  for (const auto& [programme, kind] : kinds) {
    const CampaignPlan plan{
        .number = 2, .kind = "none", .effects = {}, .family = "asymmetric", .programme = programme};
    const SealedCampaign sealed = draw_campaign(plan, 8);
    write_sealed(sealed, 8, folder / name_of(programme));
    const std::string text = read_text(folder / name_of(programme) / "campaign" / "campaign.toml");
    std::size_t count = 0;
    for (std::size_t at = text.find("kind = \"" + kind + "\""); at != std::string::npos;
         at = text.find("kind = \"" + kind + "\"", at + 1))
      ++count;
    EXPECT_EQ(count, sealed.specimen.stretches.size()) << kind;
    EXPECT_EQ(label_of(sealed).at("records"), name_of(programme));
  }
}

TEST_F(BlindFolder, CampaignHasTheNoiseThatItsLabelSays) {
  CampaignPlan plan{.number = 3, .kind = "none", .effects = {}, .family = "primary", .snr_db = 20, .dwells = 4};
  const SealedCampaign sealed = draw_campaign(plan, 8);
  write_sealed(sealed, 8, folder / "case");
  // The base is a pure harmonic here: what a fit of its frequency leaves is noise.
  const Dwell& dwell = sealed.specimen.dwells.front();
  std::istringstream text(read_text(folder / "case" / "campaign" / "records" / "0001.csv"));
  std::string line;
  std::getline(text, line);
  double squares = 0;
  int n = 0;
  while (std::getline(text, line)) {
    const double t = std::stod(line), base = std::stod(line.substr(line.find(',') + 1));
    squares += std::pow(base - dwell.drive.at(t), 2);
    ++n;
  }
  ASSERT_EQ(n, 6144);
  const double quantum = sealed.quantum[0], variance = std::pow(sealed.noise_sd[0], 2) + quantum * quantum / 12;
  EXPECT_NEAR(squares / n, variance, 5 * variance * std::sqrt(2.0 / n));
  // 20 dB under the median dwell's level
  EXPECT_GT(sealed.noise_sd[0], 0.02 * dwell.drive.amplitude / std::sqrt(2));
}

// The first draws of these campaigns run away: one in a dwell, by a coupling that softens, the other in a decay,
// which begins beyond every dwell's amplitude. Each is then the campaign that its second stream draws.
using SlowBlindFolder = BlindFolder;
TEST_F(SlowBlindFolder, ACampaignThatRunsAwayIsDrawnAgain) {
  constexpr std::size_t second_stream = 10'000'000;
  const struct {
    const char *effect, *family;
    std::uint64_t seed;
  } runaways[] = {{"cubic_coupling", "two_modes", 4}, {"quadratic_stiffness", "principal_parametric", 44}};
  for (const auto& [effect, family, seed] : runaways) {
    CampaignPlan plan{
        .number = 3, .kind = "outside", .effects = {effect}, .family = family, .snr_db = 10, .dwells = 4};
    const SealedCampaign sealed = draw_campaign(plan, seed);
    plan.number += second_stream;
    EXPECT_EQ(numbers_of(sealed.specimen), numbers_of(draw_campaign(plan, seed).specimen)) << effect;
    write_sealed(sealed, seed, folder / effect);
    for (const auto& record : std::filesystem::directory_iterator(folder / effect / "campaign" / "records"))
      EXPECT_EQ(read_text(record.path()).find("nan"), std::string::npos) << record.path();
  }
}

TEST_F(BlindFolder, SameSeedGivesTheSameBytes) {
  CampaignPlan plan{.number = 3, .kind = "none", .effects = {}, .family = "primary", .dwells = 4};
  for (const char* name : {"one", "two"}) {
    const SealedCampaign sealed = draw_campaign(plan, 8);
    write_sealed(sealed, 8, folder / name);
    write_text(folder / name / "label", label_of(sealed).dump());
  }
  EXPECT_EQ(files_in(folder / "one"), files_in(folder / "two"));
  write_sealed(draw_campaign(plan, 9), 9, folder / "other");
  EXPECT_NE(read_text(folder / "other" / "model.toml"), read_text(folder / "one" / "model.toml"));
}

TEST_F(BlindFolder, LabelsThatWereTouchedAreRefused) {
  const std::string labels = "{\"labels\": []}\n";
  write_text(folder / "labels.json", labels);
  write_text(folder / "labels.sha256", sha256(labels) + "  labels.json\n");
  EXPECT_EQ(read_labels(folder).at("labels").size(), 0u);
  std::ofstream(folder / "labels.json", std::ios::app) << " ";
  EXPECT_THROW(read_labels(folder), InputError);
  fs::remove(folder / "labels.sha256");
  EXPECT_THROW(read_labels(folder), InputError);
}

TEST_F(BlindFolder, SharedWorkIsDoneOnceAndItsFailureIsSeen) {
  std::vector<int> times(100);
  in_parallel(times.size(), 4, [&](std::size_t i) { ++times[i]; });
  EXPECT_EQ(times, std::vector<int>(100, 1));
  EXPECT_THROW(in_parallel(9, 3,
                           [](std::size_t i) {
                             if (i == 5) throw InputError("x", "", "y");
                           }),
               InputError);
}

class SlowBlindSet : public BlindFolder {};

TEST_F(SlowBlindSet, IsTheSameForAnyThreadsAndKeepsWhatIsThere) {
  // One with wrong numbers and one without a gap: quick to draw.
  SetOptions options{.campaigns = 2, .seed = 57, .size = SetSize::short_set, .threads = 1};
  generate_set(folder / "one", options, {});
  options.threads = 2;
  generate_set(folder / "two", options, {});
  const auto one = files_in(folder / "one"), two = files_in(folder / "two");
  EXPECT_EQ(one, two);
  EXPECT_GT(one.size(), 40u);
  const auto written = fs::last_write_time(folder / "one" / "labels.json");
  generate_set(folder / "one", options, {});
  EXPECT_EQ(fs::last_write_time(folder / "one" / "labels.json"), written);
  options.seed = 58;
  EXPECT_THROW(generate_set(folder / "one", options, {}), InputError);
}

}  // namespace
}  // namespace secular::blind
