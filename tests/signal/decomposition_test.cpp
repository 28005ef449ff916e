// Exact truths of the circular-hyperbolic decomposition: no noise, so every number must come back to rounding.
#include "measure/signal/decomposition.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <stdexcept>
#include <vector>

#include "gaussian.hpp"
#include "measure/signal/refine_poles.hpp"
#include "tests/signal/cramer_rao_bound.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using testing_support::cramer_rao_bound;

MatrixXd signal_of(std::span<const Pole> poles, const MatrixXd& amplitudes, Index samples, double rate) {
  return pole_functions(poles, samples, rate, 0) * amplitudes;
}

class EveryMethod : public testing::TestWithParam<PolynomialMethod> {
 protected:
  DecompositionOptions options(int order) const {
    DecompositionOptions o;
    o.order = order;
    o.method = GetParam();
    return o;
  }
};

void expect_recovered(const std::vector<Pole>& poles, const MatrixXd& amplitudes, double rate,
                      const DecompositionOptions& options, double tolerance) {
  const MatrixXd y = signal_of(poles, amplitudes, 160, rate);
  const Decomposition d = decompose(y, rate, options);
  ASSERT_EQ(d.poles.size(), poles.size());
  for (std::size_t i = 0; i < poles.size(); ++i) {
    EXPECT_EQ(d.poles[i].family, poles[i].family);
    EXPECT_NEAR(d.poles[i].frequency, poles[i].frequency, tolerance * rate);
    EXPECT_NEAR(d.poles[i].rate, poles[i].rate, tolerance * rate);
  }
  EXPECT_LT((d.amplitudes - amplitudes).cwiseAbs().maxCoeff(), tolerance * amplitudes.cwiseAbs().maxCoeff());
  EXPECT_LT((d.reconstruct(160) - y).norm(), tolerance * y.norm());
  EXPECT_NEAR(d.correlation(0), 1, tolerance);
  EXPECT_GT(d.signal_to_noise_db(0), 180);
}

TEST_P(EveryMethod, RecoversEveryFamilyToTenDigits) {
  for (const bool refine : {false, true}) {
    const auto check = [&](Pole pole, const VectorXd& amplitudes) {
      DecompositionOptions o = options(pole.family == PoleFamily::product ? 2 : 1);
      o.refine = refine;
      expect_recovered({pole}, amplitudes, 100, o, 1e-10);
    };
    check({PoleFamily::circular, 12, 0}, Eigen::Vector2d(1.5, -0.5));
    check({PoleFamily::hyperbolic, 0, 3}, Eigen::Vector2d(0.6, -0.4));
    check({PoleFamily::nyquist_hyperbolic, 0, 3}, Eigen::Vector2d(0.6, -0.4));
    check({PoleFamily::product, 110, 4}, Eigen::Vector4d(1, -0.2, 0.1, 0.3));
  }
}

TEST_P(EveryMethod, RecoversAMixtureOfFamiliesFromChannelsThatShareIt) {
  const std::vector<Pole> poles = {{PoleFamily::circular, 60, 0},
                                   {PoleFamily::circular, 140, 0},
                                   {PoleFamily::hyperbolic, 0, 4},
                                   {PoleFamily::nyquist_hyperbolic, 0, 2}};
  MatrixXd amplitudes(8, 3);
  amplitudes << 1, 0.2, -0.4, -0.3, 0.5, 0, 0.2, 0.7, 0, 0.1, -0.6, 0, 0.1, 0.02, 0.3, -0.2, 0.1, 0.1, 0.05, 0.2,
      0.1, 0.02, -0.1, 0.3;  // the third channel does not see the second tone
  for (const bool refine : {false, true}) {
    DecompositionOptions o = options(4);
    o.refine = refine;
    expect_recovered(poles, amplitudes, 100, o, 1e-10);
  }
}

TEST_P(EveryMethod, ImposedFrequenciesAndOffset) {
  const std::vector<Pole> poles = {{PoleFamily::circular, 55, 0},
                                   {PoleFamily::circular, 90, 0},
                                   {PoleFamily::constant, 0, 0, true},
                                   {PoleFamily::circular, 70, 0, true}};
  MatrixXd amplitudes(7, 1);
  amplitudes << 1, -0.4, 0.3, 0.2, 5, -0.2, 0.9;
  DecompositionOptions o = options(2);
  o.offset = true;
  o.imposed = {70};
  for (const bool refine : {false, true}) {
    o.refine = refine;
    expect_recovered(poles, amplitudes, 100, o, 1e-10);
  }
}

TEST_P(EveryMethod, RefusesWhatItCannotDo) {
  EXPECT_THROW(decompose(VectorXd::Ones(5), 1, options(2)), std::invalid_argument);
  EXPECT_THROW(decompose(VectorXd::Ones(50), 1, options(0)), std::invalid_argument);
  VectorXd bad = VectorXd::Ones(50);
  bad(7) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(decompose(bad, 1, options(2)), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(CircularHyperbolic, EveryMethod,
                         testing::Values(PolynomialMethod::least_squares, PolynomialMethod::noise_eigenvector,
                                         PolynomialMethod::lagged_covariance));

TEST(Decomposition, InvariantUnderScalingOfChannelsAndOfTime) {
  testing_support::Gaussian noise(11);
  const std::vector<Pole> poles = {{PoleFamily::circular, 60, 0}, {PoleFamily::circular, 140, 0}};
  MatrixXd amplitudes(4, 2);
  amplitudes << 1, 0.2, -0.3, 0.5, 0.2, 0.7, 0.1, -0.6;
  MatrixXd y = signal_of(poles, amplitudes, 400, 100);
  for (Index c = 0; c < 2; ++c) y.col(c) += 0.05 * noise.vector(400);
  DecompositionOptions o;
  o.order = 2;
  o.refine = true;
  const Decomposition d = decompose(y, 100, o);
  MatrixXd louder = y;
  louder.col(1) *= 1e6;  // another unit
  const Decomposition l = decompose(louder, 100, o);
  const Decomposition f = decompose(y, 1e5, o);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(l.poles[i].frequency, d.poles[i].frequency, 1e-9 * d.poles[i].frequency);
    EXPECT_NEAR(f.poles[i].frequency, 1e3 * d.poles[i].frequency, 1e-6 * d.poles[i].frequency);
    EXPECT_NEAR(l.tone(i, 1).amplitude_sd, 1e6 * d.tone(i, 1).amplitude_sd, 1e-3 * l.tone(i, 1).amplitude_sd);
    EXPECT_NEAR(f.tone(i, 0).phase_sd, d.tone(i, 0).phase_sd, 1e-6 * d.tone(i, 0).phase_sd);
  }
}

TEST(Decomposition, OriginMovesAmplitudesAndKeepsTheSignal) {
  testing_support::Gaussian noise(12);
  const std::vector<Pole> poles = {
      {PoleFamily::circular, 60, 0}, {PoleFamily::hyperbolic, 0, 2}, {PoleFamily::product, 120, 1.5}};
  VectorXd amplitudes(8);
  amplitudes << 1, 0.2, 0.3, -0.2, 0.5, 0.2, -0.3, 0.1;
  const VectorXd y = signal_of(poles, amplitudes, 300, 100).col(0) + 1e-3 * noise.vector(300);
  DecompositionOptions o;
  o.order = 4;
  o.refine = true;
  const Decomposition at_start = decompose(y, 100, o);
  o.origin_s = 1.2;
  const Decomposition later = decompose(y, 100, o);
  EXPECT_LT((at_start.reconstruct(300) - later.reconstruct(300)).norm(), 1e-9 * y.norm());
  // Uncertainty of the signal's value at one instant does not depend on where the origin is.
  const auto value_sd = [&](const Decomposition& d, double t) {
    const double h = 1e-6;
    const auto value = [&](std::vector<Pole> moved, const MatrixXd& a) {
      return (pole_functions(moved, 1, 100, t - d.origin_s) * a)(0, 0);
    };
    VectorXd slope(d.covariance.rows());
    Index k = 0;
    for (std::size_t i = 0; i < d.poles.size(); ++i) {
      for (Index j = 0; j < parameter_count(d.poles[i]); ++j) {
        std::vector<Pole> up = d.poles, down = d.poles;
        const bool frequency = j == 0 && d.poles[i].family != PoleFamily::hyperbolic;
        (frequency ? up[i].frequency : up[i].rate) += h;
        (frequency ? down[i].frequency : down[i].rate) -= h;
        slope(k++) = (value(up, d.amplitudes) - value(down, d.amplitudes)) / (2 * h);
      }
    }
    slope.tail(d.amplitudes.rows()) = pole_functions(d.poles, 1, 100, t - d.origin_s).transpose();
    return std::sqrt(slope.dot(d.covariance * slope));
  };
  EXPECT_NEAR(value_sd(later, 0.7), value_sd(at_start, 0.7), 1e-5 * value_sd(at_start, 0.7));
}

TEST(Decomposition, CovarianceIsTheInverseOfTheFisherInformationByDifferences) {
  const std::vector<Pole> poles = {{PoleFamily::circular, 60, 0},
                                   {PoleFamily::hyperbolic, 0, 2},
                                   {PoleFamily::nyquist_hyperbolic, 0, 1},
                                   {PoleFamily::product, 120, 1.5}};
  MatrixXd amplitudes(10, 2);
  amplitudes << 1, 0.2, 0.3, -0.2, 0.5, 0.2, -0.3, 0.1, 0.2, 0.4, -0.1, 0.3, 0.7, 0.2, 0.3, 0.5, -0.2, 0.1, 0.4,
      0.6;
  const Index samples = 150;
  const double rate = 100, first = -0.5 * static_cast<double>(samples - 1) / rate;
  const Eigen::Vector2d noise_sd(0.1, 0.3);
  const MatrixXd bound = cramer_rao_bound(poles, amplitudes, noise_sd, samples, rate);
  const Index unknowns = parameter_count(poles), functions = 10;
  MatrixXd jacobian = MatrixXd::Zero(2 * samples, unknowns + 2 * functions);
  const auto whitened = [&](const std::vector<Pole>& p) {
    const MatrixXd y = pole_functions(p, samples, rate, first) * amplitudes;
    VectorXd all(2 * samples);
    all << y.col(0) / noise_sd(0), y.col(1) / noise_sd(1);
    return all;
  };
  const double h = 1e-5;
  Index k = 0;
  for (std::size_t i = 0; i < poles.size(); ++i) {
    for (Index j = 0; j < parameter_count(poles[i]); ++j) {
      std::vector<Pole> up = poles, down = poles;
      const bool frequency = j == 0 && poles[i].frequency > 0;
      (frequency ? up[i].frequency : up[i].rate) += h;
      (frequency ? down[i].frequency : down[i].rate) -= h;
      jacobian.col(k++) = (whitened(up) - whitened(down)) / (2 * h);
    }
  }
  const MatrixXd g = pole_functions(poles, samples, rate, first);
  jacobian.block(0, unknowns, samples, functions) = g / noise_sd(0);
  jacobian.block(samples, unknowns + functions, samples, functions) = g / noise_sd(1);
  const MatrixXd information = jacobian.transpose() * jacobian;
  const MatrixXd unity = information * bound;
  EXPECT_LT((unity - MatrixXd::Identity(unity.rows(), unity.cols())).cwiseAbs().maxCoeff(), 1e-5);
}

}  // namespace
}  // namespace secular
