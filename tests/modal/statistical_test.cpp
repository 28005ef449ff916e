// Monte-Carlo: estimates without bias, scatter as the error bars say.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "measure/modal/amplitude_dependence.hpp"
#include "measure/modal/frequency_response.hpp"
#include "measure/modal/pole_fit.hpp"
#include "numerics/confidence.hpp"
#include "tests/modal/pole_of.hpp"
#include "tests/signal/gaussian.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST(StatisticalModal, RefinedPolesScatterAsTheirErrorBarsSay) {
  constexpr int runs = 300;
  constexpr double rate = 256, hz = 2 * std::numbers::pi;
  const Eigen::Vector2cd poles(pole_of(12.4 * hz, 0.004), pole_of(33.3 * hz, 0.002));
  MatrixXd exact(96, 2);
  for (Index k = 0; k < exact.rows(); ++k) {
    const double t = static_cast<double>(k) / rate;
    const Complex first = std::exp(poles(0) * t), second = std::exp(poles(1) * t) * Complex(0.3, 0.8);
    exact.row(k) << 2 * (0.84 * first - 0.53 * second).real(), 2 * (0.53 * first + 0.85 * second).real();
  }
  testing_support::Gaussian gaussian(17);
  Eigen::Vector4d sum = Eigen::Vector4d::Zero(), square = sum, stated = sum;
  for (int run = 0; run < runs; ++run) {
    MatrixXd noisy = exact;
    noisy.col(0) += 0.05 * gaussian.vector(exact.rows());
    noisy.col(1) += 0.02 * gaussian.vector(exact.rows());
    const PoleFit fit = refine_poles(noisy, rate, poles * Complex(1.001, 0.001));
    for (int r = 0; r < 2; ++r) {
      const Complex error = fit.poles(r) - poles(r);
      sum(2 * r) += error.real();
      sum(2 * r + 1) += error.imag();
      square(2 * r) += error.real() * error.real();
      square(2 * r + 1) += error.imag() * error.imag();
      stated(2 * r) += fit.growth_sd(r) * fit.growth_sd(r);
      stated(2 * r + 1) += fit.omega_sd(r) * fit.omega_sd(r);
    }
  }
  for (int i = 0; i < 4; ++i) {
    const double sd = std::sqrt(square(i) / runs);
    EXPECT_LT(std::abs(sum(i) / runs), 4 * sd / std::sqrt(runs)) << i;
    EXPECT_NEAR(square(i) / stated(i), 1, 0.3) << i;  // a variance of 300: 8 %
  }
}

// Lines through points that share errors with those before them, of which the points know all, a half or nothing;
// records enough to jackknife over them or not; as few as three points.
TEST(StatisticalModal, LinesScatterAsTheirErrorBarsSay) {
  struct Case {
    Index points;
    int records;
    double known;  // share of the variance
  };
  testing_support::Gaussian gaussian(23);
  for (const Case& c :
       {Case{28, 7, 1}, {28, 7, 0}, {28, 1, 1}, {28, 1, 0.5}, {28, 1, 0}, {6, 1, 1}, {3, 1, 1}, {3, 1, 0}}) {
    constexpr int runs = 500;
    const Index each = c.points / c.records;
    const VectorXd x = VectorXd::LinSpaced(c.points, 11, 2);
    VectorXd size = VectorXd::Constant(c.points, 0.02);
    if (c.known == 1) size = 0.1 / x.array();  // weak motion is known badly
    const double alike = 0.3;                  // error shared with the point before
    std::vector<int> record;
    Banded own, excess;
    for (Index i = 0; i < c.points; ++i) {
      record.push_back(static_cast<int>(i / each));
      own.push_back({c.known * size(i) * size(i)});
      excess.push_back({1});
      if (i % each == 0) continue;
      own.back().push_back(c.known * alike * size(i) * size(i - 1));
      excess.back().push_back(alike);
    }
    // Errors sqrt(keep) now + sqrt(1 - keep) before: neighbours share sqrt(keep (1 - keep)).
    const double keep = (1 + std::sqrt(1 - 4 * alike * alike)) / 2;
    int covered = 0, curved = 0;
    for (int run = 0; run < runs; ++run) {
      VectorXd error(c.points);
      double before = 0;
      for (Index i = 0; i < c.points; ++i) {
        if (i % each == 0) before = gaussian();
        const double now = gaussian();
        error(i) = size(i) * (std::sqrt(keep) * now + std::sqrt(1 - keep) * before);
        before = now;
      }
      const VectorXd y = (12.419 - 0.0199 * x.array()).matrix() + error;
      const StraightLine line = straight_line(x, y, own, excess, record);
      EXPECT_EQ(line.clustered, c.records == 7);
      const Interval interval = confidence_interval(line.intercept, line.intercept_sd, line.degrees_of_freedom);
      covered += interval.low < 12.419 && 12.419 < interval.high;
      curved += line.curvature_p < 0.05;
    }
    // 95 % but for three standard deviations of 500 draws; never less.
    EXPECT_GT(covered, 0.92 * runs) << c.points << " " << c.records << " " << c.known;
    if (c.records == 1 && c.points > 6) {
      EXPECT_LT(covered, 0.98 * runs) << c.points << " " << c.known;
    }
    EXPECT_LT(curved, 0.09 * runs) << c.points << " " << c.known;  // no more often than stated
  }
}

// Noise on the response leaves H1 alone and raises H2; noise on the force lowers H1 and leaves H2 alone.
TEST(StatisticalModal, FrequencyResponsesAreBiasedByTheOtherNoise) {
  constexpr Index samples = 64;
  constexpr int impacts = 4000;
  testing_support::Gaussian gaussian(29);
  const auto measured = [&](double force_noise, double response_noise) {
    ImpactSpectra sums;
    for (int i = 0; i < impacts; ++i) {
      ImpactBlock block{VectorXd::Zero(samples), MatrixXd::Zero(samples, 1)};
      block.force(4) = 1;
      block.responses(4, 0) = 2;  // the true response is 2 at every line
      block.force += force_noise * gaussian.vector(samples);
      block.responses.col(0) += response_noise * gaussian.vector(samples);
      sums.add(impact_spectra(block, 64, {}));
    }
    return frequency_response(sums, 64, {});
  };
  const FrequencyResponse by_response = measured(0, 0.1), by_force = measured(0.05, 0);
  const auto mean = [](const Eigen::MatrixXcd& h) { return h.col(0).segment(1, samples / 2 - 1).mean(); };
  EXPECT_LT(std::abs(mean(by_response.h1) - 2.0), 0.01);
  EXPECT_NEAR(mean(by_response.h2).real(), 2 * (1 + 64 * 0.01 / 4), 0.02);
  EXPECT_NEAR(mean(by_force.h1).real(), 2 / (1 + 64 * 0.0025), 0.02);
  EXPECT_LT(std::abs(mean(by_force.h2) - 2.0), 0.01);
  EXPECT_NEAR(by_response.coherence.col(0).segment(1, 31).mean(), 1 / (1 + 64 * 0.01 / 4), 0.01);
}

}  // namespace
}  // namespace secular
