// What a survey says of tests drawn at random: one to six modes, of which two may lie one bandwidth apart, in noise
// of 10 to 50 dB, from decays and from blows, some struck twice, some clipped. SECULAR_MODAL_DRAWS in the
// environment sets how many.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "input/input_error.hpp"
#include "input/numerical_failure.hpp"
#include "measure/modal/modal_survey.hpp"
#include "measure/modal/pole_fit.hpp"
#include "numerics/distribution.hpp"
#include "tests/campaign/write_campaign.hpp"
#include "tests/modal/noisy_modes.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;
using testing_support::CampaignData;
using testing_support::NoiseColour;
using testing_support::NoisyModes;

constexpr double turn_of_one_hertz = 2 * std::numbers::pi;

struct DrawnTest {
  std::string kind;
  NoisyModes made;
};

DrawnTest drawn(std::uint64_t seed) {
  const bool struck = seed % 3 == 2;
  const int modes = 1 + static_cast<int>(seed / 3 % 6);
  NoisyModes m =
      testing_support::random_modes(struck ? RecordKind::impact : RecordKind::free_decay, modes, seed + 5000);
  m.snr_db = 10 + 40 * static_cast<double>(seed * 37 % 100) / 100;
  m.samples = std::max(m.samples, 2048);
  const std::uint64_t extra = seed / 18 % 4;
  if (modes > 1 && extra == 0) {  // one bandwidth apart
    const double width = 2 * std::abs(m.poles[0].real());
    m.poles[1] = {m.poles[0].real(), m.poles[0].imag() + width};
    m.strengths[1] = 0.7 * m.strengths[0];
  }
  if (extra == 1) m.clipped_at = 0.7;
  if (struck && extra == 2) m.second_hit_s = 0.03;
  std::string kind = struck ? "blows" : "decays";
  // Closer than twice their bandwidths.
  bool close = false;
  for (std::size_t r = 1; r < m.poles.size(); ++r)
    close =
        close || std::abs(m.poles[r] - m.poles[r - 1]) < 4 * std::max(-m.poles[r].real(), -m.poles[r - 1].real());
  if (close) kind += ", close modes";
  if (m.clipped_at > 0) kind += ", clipped";
  if (m.second_hit_s > 0) kind += ", struck twice";
  return {kind, m};
}

// With what it dropped.
ModalSurvey surveyed(const CampaignData& data, std::uint64_t seed) {
  const fs::path folder = testing_support::process_folder() / ("secular_draws_" + std::to_string(seed));
  fs::remove_all(folder);
  write_campaign(data.campaign, data.samples, folder);
  ModalSurvey survey;
  try {
    survey = modal_survey(folder, {});
  } catch (const NumericalFailure& failure) {  // nothing stands out of the noise
    survey.warnings.emplace_back(failure.what());
  } catch (const InputError& error) {  // nothing is left of a record
    survey.warnings.emplace_back(error.what());
  }
  fs::remove_all(folder);
  return survey;
}

// The first row behind all that reach the largest value of their channel more than once.
int behind_clipped(const NoisyModes& m, const CampaignData& data) {
  int row = 0;
  for (const Record& record : data.samples)
    for (std::size_t c = record.channels.size() - static_cast<std::size_t>(m.channels); c < record.channels.size();
         ++c) {
      const std::vector<double>& x = record.channels[c];
      for (const double end : {*std::max_element(x.begin(), x.end()), *std::min_element(x.begin(), x.end())})
        if (std::count(x.begin(), x.end(), end) > 1)
          row = std::max(row, static_cast<int>(std::find(x.rbegin(), x.rend(), end).base() - x.begin()));
    }
  return std::min(row, m.samples - 200);
}

// What maximum likelihood over all samples says of the true poles, begun at them: in white noise its standard
// deviations are the Cramer-Rao bound.
PoleFit best_fit(const NoisyModes& m, const CampaignData& data) {
  int first = m.kind == RecordKind::impact ? 80 + static_cast<int>(m.second_hit_s * m.rate_hz) : 0;
  if (m.clipped_at > 0) first = std::max(first, behind_clipped(m, data));
  Eigen::MatrixXd samples(m.samples - first, m.channels * m.records);
  for (int r = 0; r < m.records; ++r)
    for (int c = 0; c < m.channels; ++c) {
      const auto& channels = data.samples[static_cast<std::size_t>(r)].channels;
      const std::vector<double>& x = channels[channels.size() - static_cast<std::size_t>(m.channels - c)];
      samples.col(r * m.channels + c) =
          Eigen::Map<const Eigen::VectorXd>(x.data() + first, static_cast<Eigen::Index>(x.size()) - first);
    }
  return refine_poles(
      samples, m.rate_hz,
      Eigen::Map<const Eigen::VectorXcd>(m.poles.data(), static_cast<Eigen::Index>(m.poles.size())));
}

struct Score {
  int draws = 0, with_false = 0, with_missed = 0, modes = 0, found = 0, intervals = 0, frequency = 0, damping = 0;
  double square = 0;  // of errors over the Cramer-Rao bound
  int bounded = 0;

  void operator+=(const Score& o) {
    draws += o.draws, with_false += o.with_false, with_missed += o.with_missed, modes += o.modes, found += o.found;
    intervals += o.intervals, frequency += o.frequency, damping += o.damping, square += o.square,
        bounded += o.bounded;
  }
};

Score score_of(const DrawnTest& test, std::uint64_t seed) {
  const NoisyModes& m = test.made;
  const CampaignData data = testing_support::noisy_campaign(m, seed);
  const PoleFit best = best_fit(m, data);
  std::vector<bool> taken(m.poles.size(), false);
  Score score;
  score.draws = 1;
  score.modes = static_cast<int>(m.poles.size());
  const ModalSurvey survey = surveyed(data, seed);
  for (const SurveyMode& mode : survey.modes) {
    std::size_t nearest = m.poles.size();
    double least = 1;
    for (std::size_t r = 0; r < m.poles.size(); ++r) {
      const double apart =
          std::abs(mode.natural_frequency_hz * turn_of_one_hertz / natural_frequency(m.poles[r]) - 1);
      if (taken[r] || apart > std::max(0.01, 3 * damping_ratio(m.poles[r])) || apart > least) continue;
      nearest = r;
      least = apart;
    }
    if (nearest == m.poles.size()) {
      score.with_false = 1;
      if (std::getenv("SECULAR_MODAL_TELL"))
        std::cout << "  draw " << seed << " (" << test.kind << "): no mode at " << mode.natural_frequency_hz
                  << " Hz, damping " << mode.damping_ratio << '\n';
      continue;
    }
    taken[nearest] = true;
    ++score.found;
    const double omega = natural_frequency(m.poles[nearest]), damping = damping_ratio(m.poles[nearest]);
    if (const std::optional<Interval> hz = mode.frequency_interval_hz()) {
      const std::optional<Interval> ratio = mode.damping_interval();
      const bool holds = hz->low < omega / turn_of_one_hertz && omega / turn_of_one_hertz < hz->high;
      ++score.intervals;
      score.frequency += holds;
      score.damping += ratio && ratio->low < damping && damping < ratio->high;
      if (!holds && std::getenv("SECULAR_MODAL_TELL"))
        std::cout << "  draw " << seed << " (" << test.kind << "): " << omega / turn_of_one_hertz << " Hz, said "
                  << mode.natural_frequency_hz << " +- " << mode.natural_frequency_sd_hz << ", bound "
                  << best.omega_sd(static_cast<Eigen::Index>(nearest)) / turn_of_one_hertz << ", " << mode.from
                  << '\n';
    }
    if (m.kind == RecordKind::free_decay && m.colour == NoiseColour::white && m.clipped_at == 0) {
      const double error = mode.natural_frequency_hz * turn_of_one_hertz - omega;
      score.square += std::pow(error / best.omega_sd(static_cast<Eigen::Index>(nearest)), 2);
      ++score.bounded;
      const double bounds = std::abs(error) / best.omega_sd(static_cast<Eigen::Index>(nearest));
      if (bounds > 3 && std::getenv("SECULAR_MODAL_TELL"))
        std::cout << "  draw " << seed << " (" << test.kind << "): error of " << bounds << " bounds, said "
                  << mode.natural_frequency_hz << " +- " << mode.natural_frequency_sd_hz << ", " << mode.from
                  << '\n';
    }
  }
  // One that a fit which knows of all others does not know to a fifth of its half bandwidth may be missed.
  for (std::size_t r = 0; r < m.poles.size(); ++r)
    if (!taken[r] && best.omega_sd(static_cast<Eigen::Index>(r)) < 0.2 * std::abs(m.poles[r].real())) {
      score.with_missed = 1;
      if (std::getenv("SECULAR_MODAL_TELL"))
        std::cout << "  draw " << seed << " (" << test.kind << "): missed "
                  << natural_frequency(m.poles[r]) / turn_of_one_hertz << " Hz, damping "
                  << damping_ratio(m.poles[r]) << ", channels " << m.channels << '\n';
      if (std::getenv("SECULAR_MODAL_TELL")) {
        for (const DroppedPole& pole : survey.dropped)
          std::cout << "    dropped " << natural_frequency(pole.pole) / turn_of_one_hertz << " Hz: " << pole.reason
                    << '\n';
        for (const SurveyTone& tone : survey.tones) std::cout << "    tone " << tone.reason() << '\n';
        for (const std::string& warning : survey.warnings) std::cout << "    " << warning << '\n';
      }
    }
  return score;
}

void print(const std::string& kind, const Score& s) {
  const auto share = [](int part, int all) { return all > 0 ? 100.0 * part / all : 0; };
  std::cout << kind << ": " << s.draws << " draws, " << s.found << " of " << s.modes << " modes; intervals hold "
            << share(s.frequency, s.intervals) << " % (frequency), " << share(s.damping, s.intervals)
            << " % (damping); no spurious mode in " << share(s.draws - s.with_false, s.draws)
            << " %, none missed in " << share(s.draws - s.with_missed, s.draws) << " %";
  if (s.bounded > 0) std::cout << "; error " << std::sqrt(s.square / s.bounded) << " times the bound";
  std::cout << '\n';
}

TEST(SlowModalDraws, IntervalsHoldAndModesAreThoseOfTheStructure) {
  const char* more = std::getenv("SECULAR_MODAL_DRAWS");
  const std::uint64_t draws = more != nullptr ? static_cast<std::uint64_t>(std::atoi(more)) : 108;
  std::map<std::string, Score> by_kind;
  Score all;
  const char* begin = std::getenv("SECULAR_MODAL_FIRST");
  for (std::uint64_t seed = begin ? static_cast<std::uint64_t>(std::atoi(begin)) : 0; seed < draws; ++seed) {
    const DrawnTest test = drawn(seed);
    const Score score = score_of(test, seed);
    by_kind[test.kind] += score;
    all += score;
  }
  for (const auto& [kind, score] : by_kind) print(kind, score);
  print("all", all);
  if (more != nullptr) return;  // by hand
  // Where no two modes overlap and nothing is clipped.
  Score apart = by_kind["decays"];
  apart += by_kind["blows"];
  EXPECT_GT(binomial_upper_tail(apart.intervals - apart.frequency, apart.intervals, 0.07), 1e-3);
  EXPECT_GT(binomial_upper_tail(apart.intervals - apart.damping, apart.intervals, 0.07), 1e-3);
  EXPECT_GT(binomial_upper_tail(apart.with_false, apart.draws, 0.02), 1e-3);
  // Errors of frequencies are 1.2 times the Cramer-Rao bound at most.
  EXPECT_GT(chi_squared_upper_tail(apart.square / 1.44, apart.bounded), 1e-3);
  EXPECT_GT(binomial_upper_tail(all.with_false, all.draws, 0.02), 1e-3);
}

}  // namespace
}  // namespace secular
