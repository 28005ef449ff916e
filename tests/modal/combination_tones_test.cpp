// Harmonics and combination tones of a vibration that is not linear are no modes; a mode near one is.
#include "measure/modal/combination_tones.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <random>
#include <vector>

#include "measure/modal/modal_survey.hpp"
#include "measure/modal/pole.hpp"
#include "tests/campaign/write_campaign.hpp"
#include "tests/modal/structure_campaign.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;
constexpr double turn = 2 * std::numbers::pi;

// Known to 1e-4 of its rate, and does not move with amplitude.
DecayingMotion still(double hz, double rate, double displacement) {
  DecayingMotion motion;
  motion.pole = {-rate, turn * hz};
  motion.growth_sd = motion.omega_sd = 1e-3 * rate;
  motion.rate = {rate, rate};
  motion.omega = {turn * hz, turn * hz};
  motion.followed = true;
  motion.displacement = displacement;
  return motion;
}

std::vector<CombinationMatch> combinations_of(const std::vector<DecayingMotion>& motions) {
  return find_combinations(motions, 0.05);
}

TEST(CombinationTones, SumsAndDifferencesWithTheSumOfTheRates) {
  const DecayingMotion first = still(80, 1, 1), second = still(297, 2, 0.1);
  struct Case {
    int n, m;
  };
  for (const Case& c : {Case{2, 0}, {3, 0}, {1, 1}, {1, -1}, {2, 1}, {2, -1}, {1, 2}}) {
    const double hz = std::abs(c.n * 80 + c.m * 297), rate = c.n + 2 * std::abs(c.m);
    const std::vector<CombinationMatch> found = combinations_of({first, second, still(hz, rate, 1e-3)});
    ASSERT_EQ(found.size(), 1u) << c.n << " " << c.m;
    EXPECT_EQ(found[0].motion, 2u);
    EXPECT_EQ(found[0].verdict, CombinationVerdict::tone) << c.n << " " << c.m;
    EXPECT_EQ(found[0].combination.order(), c.n + std::abs(c.m));
    EXPECT_LT(found[0].chance, 0.05);
    // With the damping ratio of a mode of its own.
    const std::vector<CombinationMatch> mode = combinations_of({first, second, still(hz, 1.2 * rate, 1e-3)});
    ASSERT_EQ(mode.size(), 1u);
    EXPECT_EQ(mode[0].verdict, CombinationVerdict::own_rate);
    // Off by ten standard deviations.
    EXPECT_TRUE(combinations_of({first, second, still(hz + 0.02 * rate, rate, 1e-3)}).empty()) << c.n << " " << c.m;
  }
}

TEST(CombinationTones, ATonesPartnersAreStrongerAndFollowed) {
  const DecayingMotion first = still(80, 1, 1), tone = still(160, 2, 1e-2);
  ASSERT_EQ(combinations_of({tone, first}).size(), 1u);
  EXPECT_EQ(combinations_of({tone, first})[0].motion, 0u);
  EXPECT_TRUE(combinations_of({still(80, 1, 1), still(160, 2, 2)}).empty());
  DecayingMotion lost = first;
  lost.followed = false;
  EXPECT_TRUE(combinations_of({lost, tone}).empty());
  // A harmonic of a harmonic is one of the mode.
  const std::vector<CombinationMatch> both = combinations_of({first, tone, still(320, 4, 1e-4)});
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[1].combination.times[0], 4);
}

TEST(CombinationTones, RatesAndChanceThatDoNotTell) {
  DecayingMotion vague = still(160, 2, 1e-2);
  vague.growth_sd = 0.6;
  std::vector<CombinationMatch> found = combinations_of({still(80, 1, 1), vague});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].verdict, CombinationVerdict::rates_unknown);
  // A partner that moves over a tenth of all frequencies.
  DecayingMotion wide = still(80, 1, 1);
  wide.omega = {turn * 76, turn * 84};
  found = combinations_of({wide, still(160, 2, 1e-2)});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].verdict, CombinationVerdict::by_chance);
}

// Blows of different strength: the amplitude of a harmonic goes with the square of its mode's, that of a mode in
// proportion, though its pole is that of the harmonic.
TEST(CombinationTones, AmplitudesFromRecordToRecord) {
  DecayingMotion first = still(80, 1, 1), tone = still(160, 2, 1e-2), vague = tone;
  vague.growth_sd = 0.6;
  DecayingMotion mode = tone;
  const double blows[] = {0.5, 0.8, 1.0, 1.7, 2.0}, scatter[] = {1.01, 0.99, 1.0, 0.98, 1.02};
  for (std::size_t r = 0; r < 5; ++r) {
    first.amplitudes.push_back(blows[r]);
    vague.amplitudes.push_back(0.01 * blows[r] * blows[r] * scatter[r]);
    mode.amplitudes.push_back(0.01 * blows[r] * scatter[r]);
  }
  std::vector<CombinationMatch> found = combinations_of({first, vague});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].verdict, CombinationVerdict::tone);
  found = combinations_of({first, mode});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].verdict, CombinationVerdict::own_amplitude);
}

// Of modes that lie anywhere few are found at combinations of others, and hardly one is called a tone: what it
// takes is a rate of the same size as well.
TEST(CombinationTones, ModesAnywhereAreHardlyEverTones) {
  std::mt19937_64 random(11);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  int modes = 0, matched = 0, tones = 0;
  for (int draw = 0; draw < 2000; ++draw) {
    std::vector<DecayingMotion> motions;
    for (int r = 0; r < 5; ++r) {
      const double hz = uniform(10, 200), damping = std::exp(uniform(std::log(0.001), std::log(0.03)));
      motions.push_back(still(hz, damping * turn * hz, std::pow(10, -uniform(0, 2))));
      motions.back().growth_sd = motions.back().omega_sd = 0.03 * motions.back().rate.low;
    }
    modes += 5;
    for (const CombinationMatch& match : combinations_of(motions)) {
      ++matched;
      tones += match.verdict == CombinationVerdict::tone;
    }
  }
  EXPECT_LT(matched, 0.05 * modes);
  EXPECT_LT(tones, 0.01 * modes);
}

class CombinationTonesOf : public testing::Test {
 protected:
  void TearDown() override { fs::remove_all(folder); }

  // A softening mode at 30 Hz, another at 105 Hz, the square of their sum, and a linear mode.
  ModalSurvey survey_of(double linear_hz, double linear_rate) const {
    constexpr double rate_hz = 1024;
    testing_support::Gaussian gaussian(7);
    Campaign campaign = testing_support::empty_campaign(rate_hz, false);
    Record record;
    record.sample_rate_hz = rate_hz;
    record.channels.assign(3, {});
    double a = 1, b = 0.4, phase = 0.3;
    for (int i = 0; i < 6144; ++i) {
      const double t = i / rate_hz, x = a * std::cos(phase), y = b * std::cos(turn * 105 * t + 1),
                   square = 0.1 * (x + y) * (x + y),
                   z = 0.1 * std::exp(-linear_rate * t) * std::cos(turn * linear_hz * t + 2);
      record.channels[0].push_back(x + y + square + z + 1e-4 * gaussian());
      record.channels[1].push_back(x - 0.5 * y + 0.4 * square - z + 1e-4 * gaussian());
      record.channels[2].push_back(0.5 * x + y - 0.7 * square + 0.6 * z + 1e-4 * gaussian());
      phase += turn * (30 - 0.05 * a) / rate_hz;
      a *= std::exp(-(0.6 + 0.2 * a) / rate_hz);
      b *= std::exp(-1.1 / rate_hz);
    }
    RecordEntry entry;
    entry.kind = RecordKind::free_decay;
    entry.file = "records/0.csv";
    campaign.records.push_back(entry);
    write_campaign(campaign, {record}, folder);
    return modal_survey(folder, {});
  }

  const fs::path folder = testing_support::process_folder() / "secular_combination_tones";
};

TEST_F(CombinationTonesOf, ASquareOfTwoModes) {
  const ModalSurvey survey = survey_of(222, 2.5);
  std::vector<double> modes, tones;
  for (const SurveyMode& mode : survey.modes) modes.push_back(std::round(mode.natural_frequency_hz));
  for (const SurveyTone& tone : survey.tones) tones.push_back(std::round(tone.found.natural_frequency_hz));
  EXPECT_EQ(modes, (std::vector<double>{30, 105, 222}));
  EXPECT_EQ(tones, (std::vector<double>{60, 75, 135, 210}));
  ASSERT_EQ(survey.tones.size(), 4u);
  EXPECT_EQ(survey.tones[0].name(), "2 v1");
  EXPECT_EQ(survey.tones[1].name(), "v2 - v1");
  for (const ModeWindow& window : survey.windows) {
    const SurveyMode& mode = survey.modes.at(static_cast<std::size_t>(window.mode));
    EXPECT_NEAR(natural_frequency(window.pole) / turn, mode.natural_frequency_hz, 1);
  }
}

}  // namespace
}  // namespace secular
