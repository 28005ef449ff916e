// Monte-Carlo: estimates without bias, scatter as the error bars say.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "measure/modal/amplitude_dependence.hpp"
#include "measure/modal/frequency_response.hpp"
#include "measure/modal/pole_fit.hpp"
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

TEST(StatisticalModal, LinesScatterAsTheirErrorBarsSay) {
  constexpr int runs = 500;
  testing_support::Gaussian gaussian(23);
  const VectorXd x = VectorXd::LinSpaced(28, 2, 11);
  std::vector<int> cluster;
  for (int i = 0; i < 28; ++i) cluster.push_back(i % 7);
  double square = 0, stated = 0, outside = 0;
  for (int run = 0; run < runs; ++run) {
    const VectorXd y = (12.419 - 0.0199 * x.array()).matrix() + 0.02 * gaussian.vector(28);
    const StraightLine line = straight_line(x, y, cluster);
    EXPECT_TRUE(line.clustered);
    square += std::pow(line.intercept - 12.419, 2);
    stated += line.intercept_sd * line.intercept_sd;
    outside += line.curvature_p < 0.05;
  }
  EXPECT_NEAR(square / stated, 1, 0.3);
  EXPECT_LT(outside / runs, 0.09);  // a straight line is called curved no more often than stated
}

// Noise on the response leaves H1 alone and raises H2; noise on the force lowers H1 and leaves H2 alone.
TEST(StatisticalModal, FrequencyResponsesAreBiasedByTheOtherNoise) {
  constexpr Index samples = 64;
  constexpr int impacts = 4000;
  testing_support::Gaussian gaussian(29);
  const auto measured = [&](double force_noise, double response_noise) {
    std::vector<ImpactBlock> blocks;
    for (int i = 0; i < impacts; ++i) {
      ImpactBlock block{VectorXd::Zero(samples), MatrixXd::Zero(samples, 1)};
      block.force(4) = 1;
      block.responses(4, 0) = 2;  // the true response is 2 at every line
      block.force += force_noise * gaussian.vector(samples);
      block.responses.col(0) += response_noise * gaussian.vector(samples);
      blocks.push_back(std::move(block));
    }
    return frequency_response(blocks, 64, {});
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
