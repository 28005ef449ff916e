// Which poles are modes: noise, whatever its colour, hardly makes one; true ones are not lost; growth is seen.
#include "measure/modal/pole_support.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "input/numerical_failure.hpp"
#include "measure/modal/modal_survey.hpp"
#include "measure/modal/noise_whitening.hpp"
#include "measure/modal/record_scatter.hpp"
#include "numerics/distribution.hpp"
#include "tests/campaign/write_campaign.hpp"
#include "tests/modal/noisy_modes.hpp"
#include "tests/modal/pole_of.hpp"
#include "tests/process_folder.hpp"
#include "tests/signal/gaussian.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;
using testing_support::NoiseColour;
using testing_support::NoisyModes;

constexpr double hertz = 2 * std::numbers::pi;

// Modes that a survey finds; none where it says that nothing stands out.
std::vector<SurveyMode> modes_of(const NoisyModes& made, std::uint64_t seed) {
  const fs::path folder = testing_support::process_folder() / ("secular_support_" + std::to_string(seed));
  fs::remove_all(folder);
  const testing_support::CampaignData data = testing_support::noisy_campaign(made, seed);
  write_campaign(data.campaign, data.samples, folder);
  std::vector<SurveyMode> modes;
  try {
    modes = modal_survey(folder, {}).modes;
  } catch (const NumericalFailure& error) {
    const std::string what = error.what();
    EXPECT_TRUE(what.find("stands out of the noise") != std::string::npos ||
                what.find("no mode stands") != std::string::npos)
        << what;
  }
  fs::remove_all(folder);
  return modes;
}

struct Count {
  int runs = 0, with_false = 0, missed = 0, modes = 0;
};

// Each mode found belongs to the nearest true one that is within three bandwidths (or 1 %) and not taken.
void count(Count& sum, const NoisyModes& made, std::uint64_t seed) {
  std::vector<bool> taken(made.poles.size(), false);
  bool any_false = false;
  for (const SurveyMode& mode : modes_of(made, seed)) {
    std::size_t best = made.poles.size();
    double nearest = 1;
    for (std::size_t r = 0; r < made.poles.size(); ++r) {
      const double apart = std::abs(mode.natural_frequency_hz * hertz / natural_frequency(made.poles[r]) - 1);
      if (taken[r] || apart > std::max(0.01, 3 * damping_ratio(made.poles[r])) || apart > nearest) continue;
      best = r;
      nearest = apart;
    }
    if (best < made.poles.size())
      taken[best] = true;
    else
      any_false = true;
  }
  ++sum.runs;
  sum.with_false += any_false;
  sum.modes += static_cast<int>(made.poles.size());
  for (const bool found : taken) sum.missed += !found;
}

// Before noise was tested for, 60 % of such surveys of decays and 85 % of impacts held false modes.
TEST(StatisticalPoleSupport, NoiseHardlyMakesAMode) {
  for (const RecordKind kind : {RecordKind::free_decay, RecordKind::impact}) {
    Count sum;
    for (std::uint64_t seed = 0; seed < 30; ++seed) count(sum, testing_support::random_modes(kind, 1, seed), seed);
    EXPECT_GT(binomial_upper_tail(sum.with_false, sum.runs, 0.01), 1e-3) << sum.with_false;
    EXPECT_LE(sum.missed, 3);  // those whose noise, at 10 to 20 dB, hides them
  }
}

TEST(StatisticalPoleSupport, TwoAndThreeModesAreNotLost) {
  for (const int modes : {2, 3}) {
    Count sum;
    for (std::uint64_t seed = 1000; seed < 1016; ++seed) {
      NoisyModes made = testing_support::random_modes(RecordKind::free_decay, modes, seed);
      made.snr_db = std::max(made.snr_db, 40.0);
      count(sum, made, seed);
    }
    EXPECT_GT(binomial_upper_tail(sum.with_false, sum.runs, 0.01), 1e-3) << modes << ": " << sum.with_false;
    EXPECT_LE(sum.missed, sum.modes / 10) << modes;
  }
}

// A channel that repeats another one, a sum of others and a constant say nothing new.
TEST(PoleSupport, ChannelsThatRepeatOthersDoNotCount) {
  testing_support::Gaussian gaussian(61);
  const std::complex<double> pole = pole_of(20 * hertz, 0.01);
  FreeMotions motions;
  motions.channels = 2;
  motions.sample_rate_hz = 256;
  motions.groups = {"", ""};
  motions.samples.resize(1024, 4);
  for (Eigen::Index i = 0; i < motions.samples.rows(); ++i)
    for (Eigen::Index s = 0; s < 4; ++s)
      motions.samples(i, s) =
          (std::exp(pole * (static_cast<double>(i) / 256)) * std::polar(1.0, static_cast<double>(s))).real() +
          0.1 * gaussian();
  FreeMotions more = motions;
  more.channels = 5;
  more.samples.resize(1024, 10);
  for (Eigen::Index r = 0; r < 2; ++r) {
    const Eigen::MatrixXd own = motions.samples.middleCols(2 * r, 2);
    more.samples.middleCols(5 * r, 5) << own, own.col(1), Eigen::VectorXd(own.col(0) - 2 * own.col(1)),
        Eigen::VectorXd::Constant(1024, 1.7);
  }
  const PoleSupport alone = pole_support(motions, {pole}).front(), beside = pole_support(more, {pole}).front();
  ASSERT_TRUE(alone.stands);
  ASSERT_TRUE(beside.stands);
  EXPECT_LT(std::abs(alone.pole - beside.pole), 1e-3 * alone.omega_sd);
  EXPECT_NEAR(beside.omega_sd / alone.omega_sd, 1, 1e-3);
  EXPECT_NEAR(beside.growth_sd / alone.growth_sd, 1, 1e-3);
}

// Samples that were computed hold motions of the computation, far below what any sensor shows.
TEST(PoleSupport, WhatNoConverterResolvesIsNoMode) {
  const std::complex<double> first = pole_of(20 * hertz, 0.01), second = pole_of(47 * hertz, 0.004);
  for (const double share : {1e-12, 1e-8}) {
    testing_support::Gaussian gaussian(5);
    FreeMotions motions{Eigen::MatrixXd(1024, 1), 1, 256, {""}};
    for (Eigen::Index i = 0; i < motions.samples.rows(); ++i) {
      const double t = static_cast<double>(i) / 256;
      motions.samples(i, 0) =
          std::exp(first * t).real() + share * (std::exp(second * t).real() + 0.01 * gaussian());
    }
    const std::vector<PoleSupport> found = pole_support(motions, {first, second});
    EXPECT_TRUE(found[0].stands) << share;
    EXPECT_EQ(found[1].stands, share > 1e-9) << share << ": " << found[1].reason;
  }
}

TEST(PoleSupport, GrowthIsReportedWithItsErrorBar) {
  std::uint64_t seed = 50;
  for (const double damping : {-0.001, -0.01, -0.04})
    for (const int channels : {1, 3}) {
      NoisyModes made;
      made.channels = channels;
      made.rate_hz = channels == 1 ? 512 : 2048;
      made.poles = {pole_of(20 * hertz * made.rate_hz / 512, damping)};
      made.strengths = {1};
      made.colour = channels == 1 ? NoiseColour::white : NoiseColour::low;
      const std::vector<SurveyMode> modes = modes_of(made, ++seed);
      ASSERT_EQ(modes.size(), 1u) << damping;
      EXPECT_EQ(modes[0].trend(), MotionTrend::grows) << damping;
      EXPECT_LT(std::abs(modes[0].damping_ratio - damping), 4 * modes[0].damping_ratio_sd) << damping;
      EXPECT_LT(modes[0].damping_ratio_sd, std::abs(damping));
    }
}

// A mode without damping is neither said to grow nor to decay more often than 95 % intervals miss.
TEST(StatisticalPoleSupport, UndampedMotionIsNotSaidToGrow) {
  int grows = 0, runs = 0;
  for (std::uint64_t seed = 200; seed < 240; ++seed) {
    NoisyModes made;
    made.poles = {pole_of(31 * hertz, 0)};
    made.strengths = {1};
    made.snr_db = 20;
    made.colour = static_cast<NoiseColour>(seed % 4);
    for (const SurveyMode& mode : modes_of(made, seed)) {
      ++runs;
      grows += mode.trend() == MotionTrend::grows;
    }
  }
  EXPECT_GE(runs, 30);  // where noise makes the largest excursion late, little is left behind it
  EXPECT_GT(binomial_upper_tail(grows, runs, 0.025), 1e-3) << grows;
}

// A ring in one of three records of one kind is no mode of the structure.
TEST(PoleSupport, WhatOneRecordShowsAloneIsNoMode) {
  testing_support::Gaussian gaussian(3);
  const std::complex<double> mode = pole_of(20 * hertz, 0.01), ring = pole_of(70 * hertz, 0.01);
  FreeMotions motions{0.05 * gaussian.vector(2048 * 3).reshaped(2048, 3), 1, 512, {"", "", ""}};
  for (Eigen::Index i = 0; i < 2048; ++i) {
    const double t = static_cast<double>(i) / 512;
    motions.samples.row(i).array() += std::exp(mode * t).real();
    motions.samples(i, 1) += 0.3 * std::exp(ring * t).imag();
  }
  std::vector<PoleSupport> support = pole_support(motions, {mode, ring});
  EXPECT_TRUE(support[0].stands) << support[0].reason;
  EXPECT_FALSE(support[1].stands);
  EXPECT_NE(support[1].reason.find("one record"), std::string::npos) << support[1].reason;
  motions.groups = {"left", "right", "left"};  // struck elsewhere, that mode may well answer alone
  support = pole_support(motions, {mode, ring});
  EXPECT_TRUE(support[1].stands) << support[1].reason;
}

// A relaxation, of no turn or less than one, is motion but no resonance; the mode beside it keeps its values.
TEST(PoleSupport, WhatDoesNotSwingIsNoMode) {
  testing_support::Gaussian gaussian(5);
  const std::complex<double> mode = pole_of(20 * hertz, 0.01), bent = pole_of(8 * hertz, 0.6);
  const std::complex<double> slow = pole_of(0.2 * hertz, 0.5);
  FreeMotions motions{0.01 * gaussian.vector(1500), 1, 512, {""}};
  for (Eigen::Index i = 0; i < motions.samples.rows(); ++i) {
    const double t = static_cast<double>(i) / 512;
    motions.samples(i, 0) += std::exp(mode * t).real() + 2 * std::exp(-60 * t) + 0.5 * std::exp(-2 * t);
  }
  const std::vector<PoleSupport> support = pole_support(motions, {mode, bent, slow});
  ASSERT_TRUE(support[0].stands) << support[0].reason;
  EXPECT_LT(std::abs(support[0].pole.real() - mode.real()), 4 * support[0].growth_sd);
  EXPECT_LT(std::abs(support[0].pole.imag() - mode.imag()), 4 * support[0].omega_sd);
  EXPECT_FALSE(support[1].stands);
  EXPECT_FALSE(support[2].stands);
}

TEST(NoiseWhitening, TakesColourAndLikenessOut) {
  testing_support::Gaussian gaussian(8);
  Eigen::MatrixXd noise(4000, 4);
  for (Eigen::Index r = 0; r < 2; ++r) {
    const Eigen::VectorXd both = testing_support::noise_of(NoiseColour::band, 4000, gaussian);
    noise.col(2 * r) = 3 * (both + testing_support::noise_of(NoiseColour::band, 4000, gaussian));
    noise.col(2 * r + 1) = both + 0.1 * testing_support::noise_of(NoiseColour::low, 4000, gaussian);
  }
  const NoiseWhitening whitening(noise, 2, 0, 1e-12);
  const Eigen::MatrixXd white = whitening(noise);
  ASSERT_EQ(white.rows(), 4000 - whitening.order());
  const auto rows = static_cast<double>(white.rows());
  for (Eigen::Index r = 0; r < 2; ++r) {
    const Eigen::MatrixXd record = white.middleCols(2 * r, 2);
    EXPECT_LT((record.transpose() * record / rows - Eigen::Matrix2d::Identity()).norm(), 1e-9);
    for (Eigen::Index lag = 1; lag < 20; ++lag) {
      const Eigen::Index kept = record.rows() - lag;
      const Eigen::MatrixXd later = record.topRows(kept).transpose() * record.bottomRows(kept) / rows;
      EXPECT_LT(later.diagonal().cwiseAbs().maxCoeff(), 5 / std::sqrt(rows)) << lag;
    }
  }
}

// Records of two channels, each mode with a shape of its own, begun anew in every record.
FreeMotions motions_of(const std::vector<std::complex<double>>& poles, int records,
                       testing_support::Gaussian& gaussian) {
  constexpr double level = 0.05, rate_of_samples = 128, shapes[2][2] = {{1, 0.7}, {0.8, -0.6}};
  FreeMotions motions{Eigen::MatrixXd(512, 2 * records), 2, rate_of_samples,
                      std::vector<std::string>(static_cast<std::size_t>(records), "")};
  for (int record = 0; record < records; ++record) {
    std::vector<std::complex<double>> begin;
    for (std::size_t r = 0; r < poles.size(); ++r) begin.push_back(std::polar(1.0, 3 * gaussian()));
    for (int i = 0; i < 512; ++i)
      for (int c = 0; c < 2; ++c) {
        double y = level * gaussian();
        for (std::size_t r = 0; r < poles.size(); ++r)
          y += shapes[r][c] * (begin[r] * std::exp(poles[r] * (i / rate_of_samples))).real();
        motions.samples(i, 2 * record + c) = y;
      }
  }
  return motions;
}

TEST(PoleSupport, TwoModesSeenAsOneAreTwo) {
  const std::complex<double> first(-1, 20 * hertz), second(-1, 20 * hertz + 2);  // one bandwidth apart
  testing_support::Gaussian gaussian(71);
  constexpr int runs = 20;
  int held = 0;
  for (int run = 0; run < runs; ++run) {
    std::vector<PoleSupport> found =
        pole_support(motions_of({first, second}, 2, gaussian), {0.5 * (first + second)});
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[1].beside, 0);
    if (found[0].value.imag() > found[1].value.imag()) std::swap(found[0], found[1]);
    for (std::size_t r = 0; r < 2; ++r) {
      ASSERT_TRUE(found[r].stands) << found[r].reason;
      held += std::abs(found[r].value.imag() - (r == 0 ? first : second).imag()) < 1.96 * found[r].omega_error;
    }
  }
  EXPECT_GT(binomial_upper_tail(2 * runs - held, 2 * runs, 0.05), 1e-3) << held;
}

// u' = p - c a_0 exp(Re u): softer and more damped at large amplitude, with a closed solution. The same motion at
// two amplitudes, of which the larger stands in ten times the noise.
TEST(PoleSupport, AMotionWhoseRecordsAreUnequallyNoisyIsOne) {
  const double growth = -1, turning = 20 * hertz;
  const std::complex<double> law(-3, -15);
  testing_support::Gaussian gaussian(79);
  constexpr int runs = 10;
  int one = 0;
  for (int run = 0; run < runs; ++run) {
    FreeMotions motions = motions_of({}, 2, gaussian);
    const Eigen::Index rows = motions.samples.rows();
    for (Eigen::Index record = 0; record < 2; ++record) {
      const double begin = record == 0 ? 1 : 0.5, noise = record == 0 ? 0.05 : 0.005;
      for (Eigen::Index i = 0; i < rows; ++i) {
        const double t = static_cast<double>(i) / motions.sample_rate_hz;
        // a' = (g + c a) a, and the integral of a is that of a' / (g + c a).
        const double shrink = std::exp(growth * t), of_law = law.real() * begin / growth;
        const double below = 1 + of_law * (1 - shrink), a = begin * shrink / below;
        const double integral = std::log(below) / -law.real();
        const double phase = turning * t + law.imag() * integral;
        for (Eigen::Index c = 0; c < 2; ++c)
          motions.samples(i, 2 * record + c) = (c == 0 ? 1 : 0.6) * a * std::cos(phase) + noise * gaussian();
      }
    }
    one += pole_support(motions, {{growth - 0.5, turning - 1}}).size() == 1;
  }
  EXPECT_EQ(one, runs);
}

TEST(PoleSupport, ErrorBarsOfOneModeInNoiseAreThoseOfTheNoise) {
  const std::complex<double> pole(-1, 20 * hertz);
  testing_support::Gaussian gaussian(73);
  constexpr int runs = 50;
  int wider = 0;
  for (int run = 0; run < runs; ++run) {
    const PoleSupport s = pole_support(motions_of({pole}, 2, gaussian), {pole}).front();
    ASSERT_TRUE(s.stands) << s.reason;
    // Its level in 2048 samples is told to 1.6 %, and differs by less from one to the other; what (M7) adds where
    // noise alarms falsely at 1 % makes bars twice as wide.
    wider += s.growth_error > 1.05 * s.growth_sd || s.omega_error > 1.05 * s.omega_sd;
  }
  EXPECT_GT(binomial_upper_tail(wider, runs, 0.01), 1e-3) << wider;
}

// One unknown; records with noise of their own, whose true values scatter.
TEST(RecordScatter, AddsWhatTheCommonValueScattersBy) {
  const std::vector<double> weights = {1, 4, 2, 0.5};
  testing_support::Gaussian gaussian(79);
  constexpr int runs = 20000;
  constexpr double between = 3;
  double squares = 0, fourth = 0, said = 0, sum = 0;
  for (const double weight : weights) sum += weight;
  for (int run = 0; run < runs; ++run) {
    std::vector<double> values;
    double mean = 0;
    for (const double weight : weights) {
      values.push_back(std::sqrt(between + 1 / weight) * gaussian());
      mean += weight * values.back() / sum;
    }
    std::vector<PoleInformation> records;
    for (std::size_t j = 0; j < weights.size(); ++j)
      records.push_back({Eigen::MatrixXd::Constant(1, 1, weights[j]),
                         Eigen::VectorXd::Constant(1, weights[j] * (values[j] - mean))});
    said += 1 / sum + record_scatter(records).front().variance;
    squares += mean * mean;
    fourth += std::pow(mean, 4);
  }
  // Cut at zero, the added variance is too large by its mean where it would be negative: a tenth at most here.
  const double true_variance = squares / runs, sampled = std::sqrt(fourth) / runs;
  EXPECT_GT(said / runs, true_variance - 4 * sampled);
  EXPECT_LT(said / runs, 1.1 * true_variance + 4 * sampled);
}

TEST(RecordScatter, TwoRecordsSayNothing) {
  const PoleInformation up{Eigen::MatrixXd::Ones(1, 1), Eigen::VectorXd::Constant(1, 9)},
      down{Eigen::MatrixXd::Ones(1, 1), Eigen::VectorXd::Constant(1, -9)};
  EXPECT_EQ(record_scatter({up, down}).front().variance, 0);
  EXPECT_GT(record_scatter({up, down, up, down}).front().variance, 0);
}

}  // namespace
}  // namespace secular
