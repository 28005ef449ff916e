#include "measure/signal/spectral_survey.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "numerics/hertz.hpp"
#include "tests/signal/gaussian.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

VectorXd survey_tone(Index samples, double rate, double hz, double amplitude, double phase) {
  VectorXd y(samples);
  for (Index i = 0; i < samples; ++i)
    y(i) = amplitude * std::cos(two_pi * hz * static_cast<double>(i) / rate + phase);
  return y;
}

// Figs. 3.1 and 3.2, Eq. (3.15).
TEST(SpectralSurvey, AnImpulseResponseHasTwoFunctionsOfTime) {
  VectorXd v(1000);
  const double damped = std::sqrt(1 - 0.025 * 0.025);
  for (Index i = 0; i < v.size(); ++i) {
    const double t = 0.1 * static_cast<double>(i);
    v(i) = std::exp(-0.025 * t) * std::sin(damped * t) / damped;
  }
  SpectralOptions options;
  options.order = 2;
  const SpectralSurvey survey = spectral_survey(v, 10, options);
  EXPECT_EQ(survey.temporal.size(), 60);
  EXPECT_EQ(survey.step.functions, 2);
  EXPECT_TRUE(survey.step.clear);
  EXPECT_GT(survey.step.ratio, 1e6);
  ASSERT_FALSE(survey.decomposition.poles.empty());
}

// Figs. 3.3 and 3.4, Eq. (3.16): the same number of states, and no step.
TEST(SpectralSurvey, AVanDerPolOscillatorHasNoOrder) {
  const double epsilon = 10;
  constexpr int steps = 1000;
  const double h = 0.1 / steps;
  double u = 0, w = 1;
  VectorXd v(1000);
  for (int i = -100; i < 1000; ++i) {
    if (i >= 0) v(i) = u;
    for (int k = 0; k < steps; ++k) {  // midpoint rule
      const double um = u + 0.5 * h * w, wm = w + 0.5 * h * (epsilon * (1 - u * u) * w - u);
      u += h * wm;
      w += h * (epsilon * (1 - um * um) * wm - um);
    }
  }
  SpectralOptions options;
  options.order = 4;
  const SpectralSurvey survey = spectral_survey(v, 10, options);
  EXPECT_FALSE(survey.step.clear);
  EXPECT_LT(survey.step.ratio, 5);
  EXPECT_GT(survey.temporal(10), 1e-2 * survey.temporal(0));
  EXPECT_TRUE(survey.tones_limited);
}

// Tables 4.1 and 4.2 on the tones of Table 4.2: with too small an order the closed forms are off by what is
// printed, with the right one the harmonics come out.
TEST(SpectralSurvey, TheShakersTones) {
  const Index samples = 10240;
  VectorXd y = survey_tone(samples, 64, 9.796872, 0.896984, 0.83) +
               survey_tone(samples, 64, 19.593744, 0.01809, 2.8) +
               survey_tone(samples, 64, 29.390616, 0.001317, 1.2);
  testing_support::Gaussian noise(3);
  for (double& value : y) value += 1.07e-3 * noise();
  SpectralOptions options;
  options.ensemble_s = 16;
  options.overlap = 0.75;
  options.order = 1;
  const SpectralSurvey one = spectral_survey(y, 64, options);
  EXPECT_EQ(one.layout.count, 37);
  const double printed_hz[] = {9.80155, 9.79857, 9.80699}, printed_db[] = {17.2, 25.3, 10.4};
  for (std::size_t m = 0; m < 3; ++m) {
    ASSERT_EQ(one.tables[0][m].terms.size(), 1u);
    EXPECT_NEAR(one.tables[0][m].terms[0].frequency_hz, printed_hz[m], 1e-4) << m;
    EXPECT_NEAR(one.tables[0][m].signal_to_noise_db, printed_db[m], 0.5) << m;
  }
  EXPECT_TRUE(one.settling && one.settling->settled);
  options.order = 0;
  const SpectralSurvey chosen = spectral_survey(y, 64, options);
  EXPECT_EQ(chosen.order, 3);
  const std::vector<TermStatistics>& refined = chosen.tables[0][3].terms;
  ASSERT_EQ(refined.size(), 3u);
  const double hz[] = {9.796872, 19.593744, 29.390616}, amplitude[] = {0.896984, 0.01809, 0.001317};
  for (std::size_t k = 0; k < 3; ++k) {
    // 37 ensembles that share samples are worth ten or more; four standard errors of their mean.
    EXPECT_NEAR(refined[k].frequency_hz, hz[k], 4 * refined[k].frequency_sd / std::sqrt(10.0)) << k;
    EXPECT_NEAR(refined[k].amplitude, amplitude[k], 4 * refined[k].amplitude_sd / std::sqrt(10.0)) << k;
    EXPECT_EQ(refined[k].ensembles, 37) << k;
  }
}

// Figs. C.2 and C.4.
TEST(SpectralSurvey, ALinearRelationFindsAPrimaryResonanceAndNoParametricOne) {
  const VectorXd excitation = survey_tone(8000, 200, 24.7, 1, 0.3);
  const LinearRelation primary = linear_relation(excitation, survey_tone(8000, 200, 24.7, 3, 1.9), 20);
  const LinearRelation parametric = linear_relation(excitation, survey_tone(8000, 200, 12.35, 3, 1.9), 20);
  EXPECT_GT(primary.explained, 0.999);
  EXPECT_LT(parametric.explained, 1e-3);
  EXPECT_GT(primary.block_correlation, 0.99);
  EXPECT_LT(parametric.block_correlation, 1e-3);
  EXPECT_NEAR(parametric.response(0), 1, 1e-12);
  EXPECT_LT(parametric.cross.cwiseAbs().maxCoeff(), 0.02);
}

// A filter that remembers longer than the delays: coherence sees all of it, and of noise beside it what is not
// noise.
TEST(SpectralSurvey, CoherenceTellsWhatAnyLinearFilterExplains) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise;
  VectorXd excitation(16384), response(16384);
  double x = 0, v = 0;
  for (Eigen::Index i = 0; i < response.size(); ++i) {
    excitation(i) = noise(random);
    v = 0.97 * v - 0.04 * x + excitation(i);  // a mode that rings for some hundred samples
    x += v;
    response(i) = x;
  }
  const double level = std::sqrt(response.squaredNorm() / static_cast<double>(response.size()));
  const LinearRelation clean = linear_relation(excitation, response, 20);
  EXPECT_LT(clean.explained, 0.5);
  EXPECT_GT(clean.coherent->share, 0.97);
  EXPECT_EQ(clean.coherent->window, 2048);
  for (Eigen::Index i = 0; i < response.size(); ++i) response(i) += level * noise(random);
  EXPECT_NEAR(linear_relation(excitation, response, 20).coherent->share, 0.5, 0.05);
  VectorXd other(16384);
  for (double& value : other) value = noise(random);
  EXPECT_LT(linear_relation(other, response, 20).coherent->share, 0.05);
  // Steady tones of other frequencies are not coherent, and of the same they are.
  const VectorXd tone = survey_tone(8192, 200, 24, 1, 0.3);
  EXPECT_LT(coherent_share(tone, survey_tone(8192, 200, 12, 3, 1.9))->share, 0.02);
  EXPECT_GT(coherent_share(tone, survey_tone(8192, 200, 24, 3, 1.9))->share, 0.999);
  EXPECT_FALSE(coherent_share(tone.head(400), tone.head(400)));
}

TEST(SpectralSurvey, RefusesWhatCannotBeAnalysed) {
  EXPECT_THROW(spectral_survey(VectorXd::Zero(100), 10, {}), std::invalid_argument);
  EXPECT_THROW(spectral_survey(VectorXd::Ones(4), 10, {}), std::invalid_argument);
  SpectralOptions options;
  options.ensemble_s = 100;
  EXPECT_THROW(spectral_survey(VectorXd::Random(100), 10, options), std::invalid_argument);
}

TEST(SpectralSurvey, SaysWhatStandsInItsWay) {
  const auto obstacle = [](const Eigen::MatrixXd& channels, const SpectralOptions& options) {
    return obstacle_to_survey(channels, 10, options);
  };
  const VectorXd noise = VectorXd::Random(100);
  VectorXd broken = noise;
  broken(7) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(obstacle(noise, {}), SurveyObstacle::none);
  EXPECT_EQ(obstacle(noise.head(15), {}), SurveyObstacle::few_samples);
  EXPECT_EQ(obstacle(broken, {}), SurveyObstacle::not_finite);
  EXPECT_EQ(obstacle(VectorXd::Zero(100), {}), SurveyObstacle::silence);
  EXPECT_EQ(obstacle(noise, {.ensemble_s = 11}), SurveyObstacle::ensemble);
  EXPECT_EQ(obstacle(noise, {.ensemble_s = 1e300}), SurveyObstacle::ensemble);
  EXPECT_EQ(obstacle(noise, {.ensemble_s = 0.01}), SurveyObstacle::ensemble);
  EXPECT_EQ(obstacle(noise, {.order = 33}), SurveyObstacle::order);
  EXPECT_EQ(obstacle(noise, {.order = 32}), SurveyObstacle::none);
  EXPECT_EQ(obstacle(noise, {.ensemble_s = 0.7}), SurveyObstacle::ensemble_for_delays);
}

// A pulse: where the rows of a way give no finite polynomial, that way has no terms.
TEST(SpectralSurvey, OfAPulseNotEveryWayHasTerms) {
  VectorXd pulse = VectorXd::Zero(512);
  pulse(0) = 1;
  EXPECT_NO_THROW(spectral_survey(pulse, 256, {}));
  Eigen::MatrixXd beside(512, 2);
  beside << pulse, VectorXd::Zero(512);
  const SpectralSurvey survey = spectral_survey(beside, 256, {});
  ASSERT_TRUE(survey.decomposition.determined);
  EXPECT_EQ(survey.tables.front().front().ensembles, 0);
}

// Where nothing stands in its way a survey comes to an end, whatever the samples are.
TEST(SpectralSurvey, ComesToAnEndWhereNothingStandsInItsWay) {
  std::mt19937 random(1);
  const auto draw = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
  int surveyed = 0;
  for (int trial = 0; trial < 150; ++trial) {
    const Index samples = draw(16, 80), channels = draw(1, 3);
    Eigen::MatrixXd record = Eigen::MatrixXd::Zero(samples, channels);
    for (Index c = 0; c < channels; ++c) {
      const int kind = draw(0, 5);
      if (kind == 1) record.col(c).setConstant(3);
      if (kind == 2) record.col(c) = survey_tone(samples, 10, 0.1 * draw(0, 50), 1, 0.3);
      if (kind == 3) record.col(c) = VectorXd::Random(samples);
      if (kind == 4) record.col(c).tail(samples / 2).setLinSpaced(0, 1e20);
      if (kind == 5) record(draw(0, static_cast<int>(samples) - 1), c) = 1;
    }
    SpectralOptions options;
    options.order = draw(0, 1) * draw(1, 27);
    options.ensemble_s = draw(0, 1) * 0.1 * draw(1, 80);
    options.overlap = 0.1 * draw(0, 9);
    options.offset = draw(0, 1) == 1;
    options.delays = draw(2, 60);
    if (obstacle_to_survey(record, 10, options) != SurveyObstacle::none) continue;
    ++surveyed;
    EXPECT_NO_THROW(spectral_survey(record, 10, options))
        << samples << " x " << channels << ", order " << options.order << ", ensembles of " << options.ensemble_s;
  }
  EXPECT_GT(surveyed, 50);
}

TEST(SpectralSurvey, TheAmplitudeSpectrumShowsPeakAmplitudes) {
  const AmplitudeSpectrum spectrum = amplitude_spectrum(survey_tone(4096, 256, 32, 1.7, 0.4), 256, 1024);
  Index at = 0;
  EXPECT_NEAR(spectrum.amplitude.col(0).maxCoeff(&at), 1.7, 1e-9);
  EXPECT_EQ(spectrum.frequency_hz(at), 32);
}

}  // namespace
}  // namespace secular
