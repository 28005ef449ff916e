// Ensembles with overlap, bispectral phase, settling.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "gaussian.hpp"
#include "measure/signal/bispectral_phase.hpp"
#include "measure/signal/ensembles.hpp"
#include "measure/signal/settling.hpp"
#include "measure/signal/tone_fit.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

TEST(Ensembles, ThirtySevenWindowsOfTheShakerRecord) {
  const EnsembleLayout layout = ensemble_layout(160 * 64, 16 * 64, 0.75);
  EXPECT_EQ(layout.count, 37);
  EXPECT_NEAR(layout.share(), 0.75, 1e-12);
  EXPECT_NEAR(ensemble_correlation(layout, 1), 0.75, 1e-12);
  EXPECT_EQ(ensemble_correlation(layout, 4), 0);
  EXPECT_THROW(ensemble_layout(10, 11, 0), std::invalid_argument);
}

TEST(EnsemblesStatistical, VarianceOfTheMeanUnderOverlapIsHonest) {
  testing_support::Gaussian random(31);
  const EnsembleLayout layout = ensemble_layout(1024, 128, 0.75);
  constexpr int draws = 1500;
  double square = 0, reported = 0;
  for (int d = 0; d < draws; ++d) {
    const VectorXd noise = random.vector(1024);
    VectorXd values(layout.count);
    for (Index k = 0; k < layout.count; ++k) values(k) = noise.segment(k * layout.step, layout.length).mean();
    const EnsembleMean mean = ensemble_mean(values, layout);
    square += mean.mean(0) * mean.mean(0);
    reported += mean.covariance(0, 0);
  }
  // Mean of the reported variances: relative error sqrt(2/(freedom * draws)) with about 10 degrees of freedom.
  EXPECT_NEAR(square / reported, 1, 3.5 * (std::sqrt(2.0 / draws) + std::sqrt(2.0 / (10 * draws))));
}

TEST(BispectralPhase, ExactWithoutNoiseAndIndependentOfTheInstant) {
  const Index n = 5;
  VectorXcd f(n), a1(n), a2(n);
  for (Index k = 0; k < n; ++k) {
    const double t = 0.37 * static_cast<double>(k);  // frequencies 7 + 11 = 18
    f(k) = std::polar(2.0, 0.3 + 18 * t);
    a1(k) = std::polar(0.5, -0.4 + 7 * t);
    a2(k) = std::polar(0.1, 1.1 + 11 * t);
  }
  const BispectralPhase phase = bispectral_phase(f, a1, a2, {100, 100, 5});
  EXPECT_NEAR(phase.gamma, 0.3 + 0.4 - 1.1, 1e-12);
  EXPECT_NEAR(phase.bicoherence, 1, 1e-12);
  EXPECT_NEAR(phase.bias, 0, 1e-12);
  EXPECT_TRUE(phase.locked);
  EXPECT_THROW(bispectral_phase(f.head(1), a1.head(1), a2.head(1), {1, 1, 1}), std::invalid_argument);
}

// Amplitudes by imposed frequencies over the ensembles of a record with three tones.
struct Amplitudes {
  VectorXcd f, a1, a2;
};
Amplitudes amplitudes_of(const MatrixXd& y, double rate, const EnsembleLayout& layout, double w1, double w2) {
  Amplitudes found{VectorXcd(layout.count), VectorXcd(layout.count), VectorXcd(layout.count)};
  const std::vector<double> frequencies = {w1, w2, w1 + w2};
  for (Index k = 0; k < layout.count; ++k) {
    const KnownFrequencyFit fit =
        known_frequency_components(y.middleRows(k * layout.step, layout.length), rate, frequencies, false);
    found.a1(k) = fit.amplitude(0, 0);
    found.a2(k) = fit.amplitude(1, 0);
    found.f(k) = fit.amplitude(2, 1);
  }
  return found;
}

TEST(BispectralPhaseStatistical, VarianceUnderOverlapIsHonestAndBiasSmall) {
  testing_support::Gaussian random(32);
  const double rate = 64, w1 = 2 * std::numbers::pi * 5.03, w2 = 2 * std::numbers::pi * 13.31;
  const VectorXd t = testing_support::sampled_times(4096, rate);
  MatrixXd clean(4096, 2);
  clean.col(0) = 0.6 * (w1 * t).array().cos() + 0.2 * (w2 * t.array() + 0.4).cos();
  clean.col(1) = ((w1 + w2) * t.array() + 1.1).cos();
  const EnsembleLayout layout = ensemble_layout(4096, 512, 0.75);
  constexpr int draws = 300;
  double square = 0, sum = 0, reported = 0;
  for (int d = 0; d < draws; ++d) {
    MatrixXd y = clean;
    for (Index c = 0; c < 2; ++c) y.col(c) += 0.3 * random.vector(4096);
    const Amplitudes a = amplitudes_of(y, rate, layout, w1, w2);
    const BispectralPhase phase = bispectral_phase(a.f, a.a1, a.a2, layout);
    const double error = phase.gamma - (1.1 - 0.4);
    square += error * error;
    sum += error;
    reported += phase.gamma_sd * phase.gamma_sd;
    EXPECT_TRUE(phase.locked);
  }
  const double sampling = std::sqrt(2.0 / draws) + std::sqrt(2.0 / (10 * draws));
  EXPECT_NEAR(square / reported, 1, 3.5 * sampling);
  EXPECT_LT(std::abs(sum / draws), 3.5 * std::sqrt(reported / draws / draws));
}

TEST(BispectralPhaseStatistical, IndependentPhasesAreNotCalledLocked) {
  testing_support::Gaussian random(33);
  constexpr int draws = 600;
  int alarms = 0;
  for (int d = 0; d < draws; ++d) {
    VectorXcd f(20), a1(20), a2(20);
    for (Index k = 0; k < 20; ++k) {
      f(k) = std::polar(1.0, 100 * random());
      a1(k) = std::polar(0.5, 100 * random());
      a2(k) = std::polar(0.2, 100 * random());
    }
    alarms += bispectral_phase(f, a1, a2, {100, 100, 20}, 0.05).locked;
  }
  EXPECT_LE(alarms, boost::math::quantile(boost::math::binomial(draws, 0.05), 0.9995));
}

VectorXd dwell(const VectorXd& t, double w, double transient, double bend) {
  return (w * t.array() + bend * t.array().square()).cos() * (1 + transient * (-0.02 * t.array()).exp());
}

TEST(SettlingStatistical, SteadyDwellPassesAndTransientIsReported) {
  testing_support::Gaussian random(35);
  const double rate = 64, w = 2 * std::numbers::pi * 9.8;
  const VectorXd t = testing_support::sampled_times(160 * 64, rate);
  const EnsembleLayout layout = ensemble_layout(t.size(), 16 * 64, 0.75);
  constexpr int draws = 150;
  int alarms = 0, seen = 0, phases = 0;
  SettlingOptions strict;
  strict.largest_drift = strict.largest_phase_drift = 0;
  for (int d = 0; d < draws; ++d) {
    const VectorXd noise = 0.1 * random.vector(t.size());
    alarms += !check_settling(dwell(t, w, 0, 0) + noise, rate, {w}, layout, true, strict).settled;
    seen += !check_settling(dwell(t, w, 0.1, 0) + noise, rate, {w}, layout, true).settled;
    phases += !check_settling(dwell(t, w, 0, 2e-5) + noise, rate, {w}, layout, true).settled;
  }
  // The error of a trend follows Student's law only about: twice the 1 % asked for is allowed.
  EXPECT_LE(alarms, boost::math::quantile(boost::math::binomial(draws, 0.02), 0.9995));
  EXPECT_EQ(seen, draws);
  EXPECT_EQ(phases, draws);
  const SettlingReport report = check_settling(dwell(t, w, 0.05, 0), rate, {w}, layout, true);
  EXPECT_FALSE(report.settled);
  EXPECT_NE(report.reason.find("tone 1 of channel 1: amplitude changes by"), std::string::npos);
  EXPECT_TRUE(check_settling(dwell(t, w, 0, 0), rate, {w}, layout, true).settled);
  EXPECT_TRUE(check_settling(dwell(t, w, 1e-4, 0), rate, {w}, layout, true).settled);  // tolerated
}

TEST(Settling, AnOffsetOfTheFrequencyIsNoDriftUnlessItIsImposed) {
  const double rate = 64, w = 2 * std::numbers::pi * 9.8;
  const VectorXd t = testing_support::sampled_times(160 * 64, rate);
  const EnsembleLayout layout = ensemble_layout(t.size(), 16 * 64, 0.75);
  const VectorXd y = dwell(t, w + 1e-3, 0, 0);
  EXPECT_TRUE(check_settling(y, rate, {w}, layout, true).settled);
  EXPECT_FALSE(check_settling(y, rate, {w}, layout, false).settled);
  EXPECT_THROW(check_settling(y, rate, {w}, ensemble_layout(300, 128, 0.5), true), std::invalid_argument);
}

}  // namespace
}  // namespace secular
