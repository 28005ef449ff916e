// What a survey says of tests drawn at random: one to six modes, of which two may lie one bandwidth apart, in noise
// of 10 to 50 dB, from decays and from blows, some struck twice, some clipped. SECULAR_MODAL_DRAWS in the
// environment sets how many.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "input/input_error.hpp"
#include "input/numerical_failure.hpp"
#include "measure/modal/modal_survey.hpp"
#include "measure/modal/noise_whitening.hpp"
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

// Samples of the free motions, rows x (channels of record 0, ...).
Eigen::MatrixXd free_samples(const NoisyModes& m, const CampaignData& data, int first) {
  Eigen::MatrixXd samples(m.samples - first, m.channels * m.records);
  for (int r = 0; r < m.records; ++r)
    for (int c = 0; c < m.channels; ++c) {
      const auto& channels = data.samples[static_cast<std::size_t>(r)].channels;
      const std::vector<double>& x = channels[channels.size() - static_cast<std::size_t>(m.channels - c)];
      samples.col(r * m.channels + c) =
          Eigen::Map<const Eigen::VectorXd>(x.data() + first, static_cast<Eigen::Index>(x.size()) - first);
    }
  return samples;
}

int first_free_row(const NoisyModes& m, const CampaignData& data) {
  const int first = m.kind == RecordKind::impact ? 80 + static_cast<int>(m.second_hit_s * m.rate_hz) : 0;
  return m.clipped_at > 0 ? std::max(first, behind_clipped(m, data)) : first;
}

// What any method could say of the true modes: maximum likelihood over all samples begun at the true poles, in the
// noise that was added. In white noise its standard deviations are the Cramer-Rao bound.
class BestFit {
 public:
  BestFit(const NoisyModes& m, const CampaignData& data, std::uint64_t seed) : rate_(m.rate_hz) {
    NoisyModes clean = m;
    clean.snr_db = 400;
    clean.clipped_at = 0;
    const int first = first_free_row(m, data);
    const Eigen::MatrixXd samples = free_samples(m, data, first);
    const Eigen::MatrixXd noise = samples - free_samples(m, testing_support::noisy_campaign(clean, seed), first);
    white_ = NoiseWhitening(noise, m.channels, 0, 0)(samples);
    fit_ = refine_poles(samples, m.rate_hz, poles_of(m.poles));
    of_white_ = refine_poles(white_, rate_, poles_of(m.poles));
  }

  const PoleFit& fit() const { return fit_; }
  double amplitude(std::size_t mode) const {
    return 2 * of_white_.residues.row(static_cast<Eigen::Index>(mode)).norm();
  }

  // Of all modes against all but this one: twice the logarithm, and what Schwarz's criterion asks of it.
  double likelihood_ratio(std::size_t mode) const {
    std::vector<std::complex<double>> others(of_white_.poles.begin(), of_white_.poles.end());
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(mode));
    return (others.empty() ? (white_.rowwise() - white_.colwise().mean()).squaredNorm()
                           : squares(refine_poles(white_, rate_, poles_of(others)))) -
           squares(of_white_);
  }
  double schwarz_price() const {
    return static_cast<double>(2 + 2 * white_.cols()) * std::log(static_cast<double>(white_.size()));
  }

 private:
  static Eigen::VectorXcd poles_of(const std::vector<std::complex<double>>& poles) {
    return Eigen::Map<const Eigen::VectorXcd>(poles.data(), static_cast<Eigen::Index>(poles.size()));
  }
  double squares(const PoleFit& fit) const {
    return fit.noise_sd.squaredNorm() * static_cast<double>(white_.rows() - 2 * fit.poles.size() - 1);
  }

  double rate_;
  Eigen::MatrixXd white_;
  PoleFit fit_, of_white_;
};

struct Score {
  int draws = 0, with_false = 0, with_missed = 0, modes = 0, found = 0, intervals = 0, frequency = 0, damping = 0;
  int missed = 0, untold = 0;  // modes, and those of them that no method could find
  double square = 0;           // of errors over the Cramer-Rao bound
  int bounded = 0;

  void operator+=(const Score& o) {
    draws += o.draws, with_false += o.with_false, with_missed += o.with_missed, modes += o.modes, found += o.found;
    intervals += o.intervals, frequency += o.frequency, damping += o.damping, missed += o.missed,
        untold += o.untold, square += o.square, bounded += o.bounded;
  }
};

// Which mode was missed, and what was found instead.
void tell_missed(const DrawnTest& test, std::uint64_t seed, std::size_t r, const BestFit& best,
                 const ModalSurvey& survey) {
  const NoisyModes& m = test.made;
  double apart = std::numeric_limits<double>::infinity();
  for (std::size_t o = 0; o < m.poles.size(); ++o)
    if (o != r)
      apart = std::min(apart, std::abs(m.poles[o].imag() - m.poles[r].imag()) /
                                  (2 * std::max(-m.poles[r].real(), -m.poles[o].real())));
  std::cout << "  draw " << seed << " (" << test.kind << "): missed "
            << natural_frequency(m.poles[r]) / turn_of_one_hertz << " Hz, damping " << damping_ratio(m.poles[r])
            << ", amplitude over noise " << best.amplitude(r) << ", bandwidths to the next " << apart
            << ", likelihood ratio " << best.likelihood_ratio(r) << " of " << best.schwarz_price() << ", channels "
            << m.channels << ", records " << m.records << '\n';
  for (const DroppedPole& pole : survey.dropped)
    std::cout << "    dropped " << natural_frequency(pole.pole) / turn_of_one_hertz << " Hz: " << pole.reason
              << '\n';
  for (const SurveyTone& tone : survey.tones) std::cout << "    tone " << tone.reason() << '\n';
  for (const std::string& warning : survey.warnings) std::cout << "    " << warning << '\n';
}

Score score_of(const DrawnTest& test, std::uint64_t seed) {
  const NoisyModes& m = test.made;
  const CampaignData data = testing_support::noisy_campaign(m, seed);
  const BestFit best(m, data, seed);
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
                  << best.fit().omega_sd(static_cast<Eigen::Index>(nearest)) / turn_of_one_hertz << ", "
                  << mode.from << '\n';
    }
    if (m.kind == RecordKind::free_decay && m.colour == NoiseColour::white && m.clipped_at == 0) {
      const double error = mode.natural_frequency_hz * turn_of_one_hertz - omega;
      score.square += std::pow(error / best.fit().omega_sd(static_cast<Eigen::Index>(nearest)), 2);
      ++score.bounded;
      const double bounds = std::abs(error) / best.fit().omega_sd(static_cast<Eigen::Index>(nearest));
      if (bounds > 3 && std::getenv("SECULAR_MODAL_TELL"))
        std::cout << "  draw " << seed << " (" << test.kind << "): error of " << bounds << " bounds, said "
                  << mode.natural_frequency_hz << " +- " << mode.natural_frequency_sd_hz << ", " << mode.from
                  << '\n';
    }
  }
  // One that a fit which knows all others does not gain by is no fault of the survey.
  for (std::size_t r = 0; r < m.poles.size(); ++r) {
    if (taken[r]) continue;
    const double ratio = best.likelihood_ratio(r), price = best.schwarz_price();
    ++score.missed;
    if (!(ratio > price)) {
      ++score.untold;
      continue;
    }
    score.with_missed = 1;
    if (std::getenv("SECULAR_MODAL_TELL")) tell_missed(test, seed, r, best, survey);
  }
  return score;
}

void print(const std::string& kind, const Score& s) {
  const auto share = [](int part, int all) { return all > 0 ? 100.0 * part / all : 0; };
  std::cout << kind << ": " << s.draws << " draws, " << s.found << " of " << s.modes << " modes; intervals hold "
            << share(s.frequency, s.intervals) << " % (frequency), " << share(s.damping, s.intervals)
            << " % (damping); no spurious mode in " << share(s.draws - s.with_false, s.draws)
            << " %, none missed that the samples tell in " << share(s.draws - s.with_missed, s.draws) << " % ("
            << s.untold << " of " << s.missed << " missed modes are told by none)";
  if (s.bounded > 0) std::cout << "; error " << std::sqrt(s.square / s.bounded) << " times the bound";
  std::cout << '\n';
}

TEST(SlowModalDraws, IntervalsHoldAndModesAreThoseOfTheStructure) {
  const char* more = std::getenv("SECULAR_MODAL_DRAWS");
  // 72: every kind of motion with every number of modes and every extra that `drawn` knows, once.
  const std::uint64_t draws = more != nullptr ? static_cast<std::uint64_t>(std::atoi(more)) : 72;
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
  EXPECT_GT(binomial_upper_tail(all.with_missed, all.draws, 0.1), 1e-3);
}

}  // namespace
}  // namespace secular
