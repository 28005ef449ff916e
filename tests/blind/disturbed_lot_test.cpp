// Structures of the blind check, their campaigns disturbed by lot: no number of `identify` may be far off unless it
// is marked, and what differs between records by chance is no cause of `diagnose`.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "blind/estimate_set.hpp"
#include "blind/random.hpp"
#include "blind/sealed_campaign.hpp"
#include "blind/sealed_files.hpp"
#include "blind/sealed_set.hpp"
#include "effects/catalogue.hpp"
#include "tests/places.hpp"
#include "tests/process_folder.hpp"

namespace secular::blind {
namespace {

namespace fs = std::filesystem;

// A campaign's numbers, as a user gets them.
std::vector<JudgedNumber> numbers_given(const SealedCampaign& sealed, std::uint64_t seed, const fs::path& folder) {
  write_sealed(sealed, seed, folder);
  const std::string command = testing_support::program() + " identify " + (folder / "campaign").string() +
                              " --model " + (folder / "model.toml").string() + " -o " + (folder / "out").string() +
                              " --threads 1 >/dev/null 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  return judged_numbers(sealed.plan.number, numbers_of(sealed.specimen),
                        nlohmann::json::parse(read_text(folder / "out/estimate.json")));
}

std::vector<JudgedNumber> identified(std::size_t number, std::uint64_t seed, const fs::path& folder) {
  CampaignPlan plan;
  plan.number = number + 1;
  plan.kind = "none";
  plan.family = families_of(Programme::dwells)[number % 4];
  Random random(seed, number);
  plan.snr_db = random.chance(0.5) ? 40 : 30;
  plan.disturbed = true;
  return numbers_given(draw_campaign(plan, seed), seed, folder);
}

// Every dwell has natural frequencies of its own; decays have those of the structure.
void scatter_besides(SealedCampaign& sealed, double sd, std::uint64_t seed) {
  Disturbances& d = sealed.disturbances;
  d.kinds.push_back("record_scatter");
  d.frequency_scatter = sd;
  d.records.resize(sealed.motions.size() + sealed.of_stretches.size());
  Random random(seed, 1);
  for (std::size_t r = 0; r < sealed.motions.size(); ++r) {
    d.records[r].frequency_factor = 1 + sd * random.gaussian();
    sealed.motions[r] = dwell_motion(sealed, sealed.specimen.dwells[r], r);
  }
}

// The same, and nothing else disturbs.
void let_frequencies_scatter(SealedCampaign& sealed, double sd, std::uint64_t seed) {
  sealed.disturbances = {};
  scatter_besides(sealed, sd, seed);
}

// Noise with a colour beside white noise of 1 % of the rms, and responses whose zero wanders.
void let_noise_be_slow(SealedCampaign& sealed) {
  Disturbances& d = sealed.disturbances;
  d = {};
  d.kinds = {"coloured_noise", "offset_wander"};
  for (const double white : sealed.noise_sd) {
    d.coloured.push_back(2 * white);
    d.wander.push_back(d.wander.empty() ? 0 : 20 * white);  // not of the excitation
  }
  d.correlation_s = 0.05;
}

// A campaign of 20 dwells and three decays at 40 dB whose lot is one disturbance, as `diagnose` sees it. `disturb`:
// puts another in place of the lot.
struct Diagnosed {
  SealedCampaign sealed;
  nlohmann::json said;
};

constexpr std::uint64_t seed_of_diagnosed = 60606;

Diagnosed diagnosed(std::size_t number, const std::vector<std::string>& effects,
                    const std::function<void(SealedCampaign&)>& disturb = {}, const std::string& options = "",
                    std::size_t dwells = 12) {
  constexpr std::uint64_t seed = seed_of_diagnosed;
  CampaignPlan plan;
  plan.number = number;
  plan.kind = effects.empty() ? "none" : "single";
  plan.effects = effects;
  plan.family = "primary";
  plan.snr_db = 40;
  plan.dwells = dwells;
  plan.disturbed = true;
  Diagnosed result{draw_campaign(plan, seed), {}};
  result.sealed.parameters.clear();
  if (disturb) disturb(result.sealed);
  const fs::path folder = testing_support::process_folder() / ("diagnosed_" + std::to_string(number));
  write_sealed(result.sealed, seed, folder);
  const std::string command = testing_support::program() + " diagnose " + (folder / "campaign").string() +
                              " --model " + (folder / "model.toml").string() + " -o " + (folder / "out").string() +
                              options + " >/dev/null 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  result.said = nlohmann::json::parse(read_text(folder / "out/diagnosis.json"));
  fs::remove_all(folder);
  return result;
}

// Sizes of a kind of disturbance by record.
std::map<std::size_t, double> sizes_of(const Diagnosed& d, const std::string& kind) {
  std::map<std::size_t, double> sizes;
  for (const auto& found : d.said.at("disturbances"))
    if (found.at("kind") == kind)
      for (std::size_t r = 0; r < d.sealed.disturbances.records.size(); ++r)
        if (found.at("record") == dwell_file(r)) sizes[r] = found.at("size").get<double>();
  return sizes;
}

// Responses that are late by up to 14 ms, another time in every record.
TEST(SlowDisturbedLot, LateRecordsAreNoCause) {
  const Diagnosed d = diagnosed(91, {}, {}, "", 20);
  ASSERT_EQ(d.sealed.disturbances.kinds, std::vector<std::string>{"late_record"});
  EXPECT_EQ(d.said.at("verdict"), "no_gap");
  const std::map<std::size_t, double> late = sizes_of(d, "late_record");
  ASSERT_GE(late.size(), 15U);
  for (const auto& [record, seconds] : late)
    EXPECT_NEAR(seconds, d.sealed.disturbances.of_record(record).late_s, 1e-3) << record;
}

// By 0.2 %, a fifth of the resonance's width.
void scatter_a_little(SealedCampaign& sealed) {
  let_frequencies_scatter(sealed, 0.002, seed_of_diagnosed);
}

// Frequencies are told relative to their mean.
TEST(SlowDisturbedLot, FrequenciesThatScatterAreNoCause) {
  const Diagnosed d = diagnosed(91, {}, scatter_a_little);
  EXPECT_EQ(d.said.at("verdict"), "no_gap");
  const std::map<std::size_t, double> own = sizes_of(d, "record_scatter");
  ASSERT_GE(own.size(), 12U);
  double mean = 0, sum = 0;
  const auto off = [&](std::size_t record, double shift) {
    return shift - (d.sealed.disturbances.of_record(record).frequency_factor - 1);
  };
  for (const auto& [record, shift] : own) mean += off(record, shift) / static_cast<double>(own.size());
  for (const auto& [record, shift] : own) {
    EXPECT_NEAR(off(record, shift), mean, 3e-4) << record;
    sum += std::pow(off(record, shift) - mean, 2);
  }
  EXPECT_LT(std::sqrt(sum / static_cast<double>(own.size())), 1e-4);
}

TEST(SlowDisturbedLot, SlowNoiseIsNoCause) {
  const Diagnosed d = diagnosed(91, {}, let_noise_be_slow);
  EXPECT_EQ(d.said.at("verdict"), "no_gap");
  EXPECT_NEAR(d.said.at("gap").at("before").get<double>(), 1, 0.05);
}

// All effects but one or two of each kind: a spring, losses, inertia, what changes with time, a sensor. (Laws
// outside of the catalogue are always tried.)
std::string without_all_but_a_few() {
  const std::set<std::string> few = {"quintic_stiffness", "coulomb_friction",        "quadratic_damping",
                                     "quadratic_inertia", "natural_frequency_drift", "channel_skew"};
  std::string without;
  for (const secular::Effect& effect : effect_catalogue().effects)
    if (!few.contains(effect.name) && effect.kind != secular::Effect::Kind::open_law &&
        effect.kind != secular::Effect::Kind::parameters)
      without += " --without " + effect.name;
  return without;
}

// Neither a phase of every record's own nor a frequency of its own leaves nothing: both do. Explanations are looked
// for beside either, beside none and beside both, so that a few effects have to do.
TEST(SlowDisturbedLot, LateRecordsWithFrequenciesThatScatterAreNoCause) {
  const Diagnosed d = diagnosed(
      91, {}, [](SealedCampaign& sealed) { scatter_besides(sealed, 0.002, seed_of_diagnosed); },
      without_all_but_a_few());
  ASSERT_EQ(d.sealed.disturbances.kinds, (std::vector<std::string>{"late_record", "record_scatter"}));
  EXPECT_EQ(d.said.at("verdict"), "no_gap");
  EXPECT_GE(sizes_of(d, "late_record").size(), 10U);
  EXPECT_GE(sizes_of(d, "record_scatter").size(), 10U);
}

TEST(SlowDisturbedLot, AnEffectIsNamedBesideFrequenciesThatScatter) {
  const Diagnosed d = diagnosed(91, {"quintic_stiffness"}, scatter_a_little);
  EXPECT_EQ(d.said.at("verdict"), "cause");
  EXPECT_EQ(d.said.at("cause"), "quintic_stiffness");
}

// Five dwells do not tell how frequencies scatter, and a law fits them as well: none is named.
TEST(SlowDisturbedLot, FewDwellsWhoseFrequenciesScatterTellNoLaw) {
  for (std::size_t number = 91; number < 94; ++number) {
    const auto scatter = [](SealedCampaign& sealed) {
      sealed.of_stretches.clear();
      sealed.specimen.stretches.clear();
      sealed.specimen.dwells.resize(5);
      sealed.motions.resize(5);
      let_frequencies_scatter(sealed, 0.003, seed_of_diagnosed);
    };
    const std::string verdict = diagnosed(number, {}, scatter).said.at("verdict");
    EXPECT_TRUE(verdict == "unknown" || verdict == "no_gap") << number << ": " << verdict;
  }
}

// All of them given, none of them doubtful (but the one whose sign nothing tells) or far off, and together within
// their error bars.
void expect_as_good_as_noise(const std::vector<JudgedNumber>& numbers, const std::string& of_unknown_sign = "") {
  double square = 0;
  for (const JudgedNumber& n : numbers) {
    EXPECT_TRUE(n.given) << n.symbol;
    EXPECT_EQ(n.doubtful, n.symbol == of_unknown_sign) << n.symbol;
    EXPECT_LT(std::abs(n.off), 6) << n.symbol;
    square += n.off * n.off / static_cast<double>(numbers.size());
  }
  EXPECT_LT(square, 4);
}

// At 60 dB an error of a phase of 0.01 rad, as truncated equations make it, counts by its square.
TEST(SlowDisturbedLot, NumbersBesideLateRecordsAreAsGoodAsTheNoise) {
  CampaignPlan plan;
  plan.number = 91;
  plan.kind = "none";
  plan.family = "primary";
  plan.snr_db = 60;
  plan.disturbed = true;
  constexpr std::uint64_t seed = 60606;
  const SealedCampaign sealed = draw_campaign(plan, seed);
  ASSERT_EQ(sealed.disturbances.kinds, std::vector<std::string>{"late_record"});
  const fs::path folder = testing_support::process_folder() / "late_at_60_db";
  const std::vector<JudgedNumber> numbers = numbers_given(sealed, seed, folder);
  fs::remove_all(folder);
  expect_as_good_as_noise(numbers, "eta1");
}

// Noise that is slower than the motion is large as a displacement: the tone of a window that was followed into it
// led to amplitudes of 1e44 m, and to numbers like that.
TEST(SlowDisturbedLot, DecaysEndWhereSlowNoiseBegins) {
  const SetOptions set{.campaigns = 118, .seed = 779, .disturbed = true, .nothing_withheld = true};
  const SealedCampaign sealed = draw_campaign(draw_plans(set).back(), set.seed);
  ASSERT_EQ(sealed.disturbances.kinds, std::vector<std::string>{"coloured_noise"});
  const fs::path folder = testing_support::process_folder() / "slow_noise";
  const std::vector<JudgedNumber> numbers = numbers_given(sealed, set.seed, folder);
  fs::remove_all(folder);
  expect_as_good_as_noise(numbers);
}

TEST(SlowDisturbedLot, NoNumberIsFarOffUnmarked) {
  constexpr std::size_t campaigns = 8;  // two of every family
  constexpr std::uint64_t seed = 60606;
  const fs::path folder = testing_support::process_folder() / "disturbed_lot";
  std::vector<std::vector<JudgedNumber>> lot(campaigns);
  in_parallel(campaigns, std::max(1U, std::thread::hardware_concurrency()), [&](std::size_t i) {
    lot[i] = identified(i, seed, sealed_folder(folder, i + 1));
    fs::remove_all(sealed_folder(folder, i + 1));
  });
  double asked = 0, given = 0, trusted = 0, held = 0, most = 0;
  for (std::size_t i = 0; i < campaigns; ++i) {
    most = std::max(most, static_cast<double>(lot[i].size()));
    for (const JudgedNumber& n : lot[i]) {
      ++asked;
      if (!n.given) continue;
      ++given;
      if (n.doubtful) continue;
      ++trusted;
      held += n.held;
      EXPECT_LT(std::abs(n.off), 6) << "campaign " << i << ", " << n.symbol;
    }
  }
  // Three standard deviations of a binomial count whose numbers go together within a campaign.
  const double band = 3 * std::sqrt(0.05 * 0.95 * trusted * most);
  EXPECT_GE(held, 0.95 * trusted - band) << held << " of " << trusted;
  EXPECT_GE(given, 0.9 * asked) << given << " of " << asked;
  EXPECT_GT(trusted, 0.5 * given) << trusted << " of " << given;
}

}  // namespace
}  // namespace secular::blind
