// Monte Carlo on the circular-hyperbolic decomposition: efficiency, and the thesis' tables and figures.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "gaussian.hpp"
#include "measure/signal/arma.hpp"
#include "measure/signal/decomposition.hpp"
#include "measure/signal/ensembles.hpp"
#include "measure/signal/exponential_fit.hpp"
#include "measure/signal/refine_poles.hpp"
#include "numerics/hertz.hpp"
#include "tests/signal/cramer_rao_bound.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using testing_support::cramer_rao_bound;

constexpr PolynomialMethod methods[] = {PolynomialMethod::least_squares, PolynomialMethod::noise_eigenvector,
                                        PolynomialMethod::lagged_covariance};

/// e^T C^-1 e over the degrees of freedom, C the Cramer-Rao bound, pooled over frequencies and amplitudes.
struct Efficiency {
  double ratio = 0, freedom = 0;
  bool inside() const {
    const boost::math::chi_squared law(freedom);
    return ratio * freedom > boost::math::quantile(law, 0.0005) &&
           ratio * freedom < boost::math::quantile(law, 0.9995);
  }
};

struct Recording {
  double noise;  // standard deviation
  Index samples;
  double rate;
};

// Every draw is decomposed into as many poles as there are.
Efficiency efficiency(const std::vector<Pole>& poles, const MatrixXd& amplitudes, const Recording& recording,
                      int draws, std::uint64_t seed) {
  const auto [noise, samples, rate] = recording;
  testing_support::Gaussian random(seed);
  const double centre = 0.5 * static_cast<double>(samples - 1) / rate;
  const MatrixXd clean = pole_functions(poles, samples, rate, -centre) * amplitudes;
  const VectorXd sd = VectorXd::Constant(amplitudes.cols(), noise);
  const Eigen::LLT<MatrixXd> bound(cramer_rao_bound(poles, amplitudes, sd, samples, rate));
  const Index unknowns = parameter_count(poles), size = unknowns + amplitudes.size();
  DecompositionOptions options;
  options.order = static_cast<int>(poles.size());
  options.refine = true;
  options.origin_s = centre;
  Efficiency result;
  for (int d = 0; d < draws; ++d) {
    MatrixXd y = clean;
    for (Index c = 0; c < y.cols(); ++c) y.col(c) += noise * random.vector(samples);
    const Decomposition fit = decompose(y, rate, options);
    VectorXd error(size);
    for (Index i = 0; i < unknowns; ++i) {
      const auto k = static_cast<std::size_t>(i);  // one unknown for every pole here
      error(i) = fit.poles[k].frequency + fit.poles[k].rate - poles[k].frequency - poles[k].rate;
    }
    error.tail(amplitudes.size()) = (fit.amplitudes - amplitudes).reshaped();
    result.ratio += error.dot(bound.solve(error));
    result.freedom += static_cast<double>(size);
  }
  result.ratio /= result.freedom;
  return result;
}

TEST(DecompositionStatistical, RefinedEstimateWithinFivePercentOfTheCramerRaoBoundFrom10dB) {
  const double decibels[] = {10, 20, 40};
  for (const double db : decibels) {
    // One tone, one channel, between bins.
    const Efficiency one = efficiency({{PoleFamily::circular, 40.37, 0}}, Eigen::Vector2d(0.6, 0.8),
                                      {std::sqrt(0.5) * std::pow(10, -db / 20), 256, 64}, 3000, 41);
    EXPECT_TRUE(one.inside()) << one.ratio << " at " << db << " dB";
    EXPECT_LT(one.ratio, 1.05) << db << " dB";
    // Four tones, four channels, the weakest at `db`.
    MatrixXd amplitudes(8, 4);
    amplitudes << 1, 0.6, -0.3, 0.9, 0.5, -0.7, 0.8, 0.2, 0.3, 0.5, 0.4, -0.4, 0.4, 0.1, -0.3, 0.3, 0.5, 0.5, -0.2,
        0.1, -0.2, 0.4, 0.6, 0.5, 0.2, -0.4, 0.3, 0.3, 0.4, 0.2, 0.4, -0.4;
    const std::vector<Pole> poles = {{PoleFamily::circular, two_pi * 12.5, 0},
                                     {PoleFamily::circular, two_pi * 33.1, 0},
                                     {PoleFamily::circular, two_pi * 45.6, 0},
                                     {PoleFamily::circular, two_pi * 58.1, 0}};
    const double weakest = std::sqrt(0.5 * (0.2 * 0.2 + 0.4 * 0.4));
    const Efficiency four = efficiency(poles, amplitudes, {weakest * std::pow(10, -db / 20), 512, 256}, 300, 42);
    EXPECT_TRUE(four.inside()) << four.ratio << " at " << db << " dB";
    EXPECT_LT(four.ratio, 1.05) << db << " dB";
  }
  // Hyperbolic and Nyquist-hyperbolic terms beside a tone, at 40 dB.
  VectorXd amplitudes(6);
  amplitudes << 1, 0.3, 0.6, -0.4, 0.5, 0.4;
  const Efficiency mixed = efficiency(
      {{PoleFamily::circular, 60, 0}, {PoleFamily::hyperbolic, 0, 3}, {PoleFamily::nyquist_hyperbolic, 0, 2}},
      amplitudes, {0.005, 160, 100}, 1500, 43);
  EXPECT_TRUE(mixed.inside()) << mixed.ratio;
  EXPECT_LT(mixed.ratio, 1.05);
}

TEST(DecompositionStatistical, TonesTwoBinsApartAreNotConfusedAt20dB) {
  testing_support::Gaussian random(44);
  const Index n = 512;
  const double rate = 256, bin = two_pi * rate / static_cast<double>(n);
  DecompositionOptions options;
  options.order = 2;
  options.refine = true;
  int confused = 0;
  for (int d = 0; d < 200; ++d) {
    // Any phases; the weaker tone at 20 dB.
    const double a = 10 * random(), b = 10 * random(), w = bin * (60 + 0.5 * random());
    VectorXd y(n);
    for (Index i = 0; i < n; ++i) {
      const double t = static_cast<double>(i) / rate;
      y(i) = std::cos(w * t + a) + std::cos((w + 2 * bin) * t + b);
    }
    y += std::sqrt(0.5) * 0.1 * random.vector(n);
    const Decomposition fit = decompose(y, rate, options);
    confused += fit.poles.size() != 2 || std::abs(fit.poles[0].frequency - w) > 0.2 * bin ||
                std::abs(fit.poles[1].frequency - w - 2 * bin) > 0.2 * bin;
  }
  EXPECT_EQ(confused, 0);
}

struct Moments {
  double sum = 0, square = 0;
  int count = 0;
  void add(double x) {
    sum += x;
    square += x * x;
    ++count;
  }
  double mean() const { return sum / count; }
  double sd() const { return std::sqrt((square - sum * sum / count) / (count - 1)); }
};

TEST(DecompositionStatistical, CableExampleOfTable44) {
  // kappa = 0.3/L, a = 0.6 L, b = -0.4 L, step 0.025 L, 25 trials. Length of the record and noise are not both
  // printed, and what is printed does not agree: one length L (41 samples) with the printed S/N of 50.5 dB has a
  // Cramer-Rao bound of 0.020/L for kappa, above the printed spread of 0.0134/L, and a fit that explains 39 dB of a
  // signal whose noise lies at 50.5 dB must be off by more than that. The printed spreads stand as 1 : 0.80 : 1.74,
  // and the errors of a and b follow that of kappa in these ratios on a record of about 250 samples (6.25 L); there
  // the printed spread of kappa needs noise at 66.5 dB, and the residual comes out near the printed 39 dB by
  // itself.
  const Index n = 251;
  const std::vector<Pole> pole = {{PoleFamily::hyperbolic, 0, 0.3}};
  const Eigen::Vector2d amplitude(0.6, -0.4);
  const VectorXd clean = pole_functions(pole, n, 40, 0) * amplitude;
  const double noise = std::sqrt(clean.squaredNorm() / static_cast<double>(n)) * std::pow(10, -66.5 / 20);
  struct Printed {
    double mean[3], sd[3], decibel;
  };
  const Printed table[] = {{{0.2957, 0.5965, -0.3923}, {0.0134, 0.0107, 0.0233}, 39.3},
                           {{0.2971, 0.5962, -0.3946}, {0.0132, 0.0106, 0.0230}, 39.6},
                           {{0.2993, 0.5994, -0.3984}, {0.0133, 0.0106, 0.0228}, 39.7}};
  const boost::math::chi_squared law(24);
  for (std::size_t m = 0; m < 3; ++m) {
    testing_support::Gaussian random(45);
    Moments moments[3];
    double left = 0;
    constexpr int draws = 1000;
    DecompositionOptions options;
    options.method = methods[m];
    for (int d = 0; d < draws; ++d) {
      const Decomposition fit = decompose(clean + noise * random.vector(n), 40, options);
      ASSERT_EQ(fit.poles[0].family, PoleFamily::hyperbolic);
      moments[0].add(fit.poles[0].rate);
      moments[1].add(fit.amplitudes(0, 0));
      moments[2].add(fit.amplitudes(1, 0));
      left += std::pow(10, -fit.signal_to_noise_db(0) / 10);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(table[m].mean[i], moments[i].mean(), 3.5 * moments[i].sd() / 5) << m << i;
      const double statistic = 24 * std::pow(table[m].sd[i] / moments[i].sd(), 2);
      EXPECT_GT(statistic, boost::math::quantile(law, 0.0005)) << m << i << " " << moments[i].sd();
      EXPECT_LT(statistic, boost::math::quantile(law, 0.9995)) << m << i << " " << moments[i].sd();
    }
    EXPECT_NEAR(-10 * std::log10(left / draws), table[m].decibel, 3) << m;
  }
  const VectorXd bound =
      cramer_rao_bound(pole, shift_matrix(pole[0], 0.5) * amplitude, VectorXd::Constant(1, 0.00164), 41, 40)
          .diagonal();
  EXPECT_GT(std::sqrt(bound(0)), 1.4 * 0.0134);
}

// The shaker of section 4.4.1: 160 s at 64 samples per second with the tones of Table 4.2, phases of Table 4.3.
VectorXd shaker_record(double noise_db, std::uint64_t seed) {
  const std::vector<Pole> poles = {{PoleFamily::circular, two_pi * 0.5, 0},
                                   {PoleFamily::circular, two_pi * 9.796872, 0},
                                   {PoleFamily::circular, two_pi * 19.593825, 0},
                                   {PoleFamily::circular, two_pi * 29.392829, 0}};
  VectorXd amplitudes(8);
  amplitudes << 0.0001, 0, 0.896984 * std::cos(0.83032), -0.896984 * std::sin(0.83032),
      0.018090 * std::cos(-2.75860), -0.018090 * std::sin(-2.75860), 0.001359 * std::cos(-1.90550),
      -0.001359 * std::sin(-1.90550);
  testing_support::Gaussian random(seed);
  const VectorXd clean = pole_functions(poles, 10240, 64, 0) * amplitudes;
  return clean + std::sqrt(clean.squaredNorm() / 10240) * std::pow(10, -noise_db / 20) * random.vector(10240);
}

TEST(DecompositionStatistical, ShakerWithTooLowAnOrderAsInTable41) {
  // With n = 1 the harmonics are the error, so that the printed numbers come back although the noise is not known.
  // 5 % of the bias of frequency and amplitude is what the printed harmonics leave open.
  const VectorXd y = shaker_record(66, 46);
  const EnsembleLayout layout = ensemble_layout(y.size(), 1024, 0.75);
  ASSERT_EQ(layout.count, 37);
  const double hertz[] = {9.80155, 9.79857, 9.80699}, gram[] = {0.8887, 0.8959, 0.8587};
  const double decibel[] = {17.2, 25.3, 10.4};
  for (std::size_t m = 0; m < 3; ++m) {
    Moments frequency, amplitude, explained;
    DecompositionOptions options;
    options.method = methods[m];
    for (Index k = 0; k < layout.count; ++k) {
      const Decomposition fit = decompose(y.segment(k * layout.step, layout.length), 64, options);
      const ToneEstimate tone = fit.tone(0, 0);
      frequency.add(tone.frequency / two_pi);
      amplitude.add(tone.amplitude);
      explained.add(fit.signal_to_noise_db(0));
    }
    EXPECT_NEAR(frequency.mean(), hertz[m], 0.05 * (hertz[m] - 9.796872)) << m;
    EXPECT_NEAR(amplitude.mean(), gram[m], 0.05 * (0.896984 - gram[m]) + 5e-4) << m;
    EXPECT_NEAR(explained.mean(), decibel[m], 0.5) << m;
  }
}

TEST(DecompositionStatistical, ShakerWithAGoodOrderAsInTable42) {
  // Noise is not printed; 66 dB below the signal, white, so that the third harmonic shows in the closed forms.
  // Primary tone and first harmonic come back in all variants, and refinement finds the second harmonic at its
  // bound.
  const VectorXd y = shaker_record(66, 47);
  const EnsembleLayout layout = ensemble_layout(y.size(), 1024, 0.75);
  for (const PolynomialMethod method : methods) {
    for (const bool refine : {false, true}) {
      Moments frequency[3], amplitude[3];
      DecompositionOptions options;
      options.order = 4;
      options.method = method;
      options.refine = refine;
      for (Index k = 0; k < layout.count; ++k) {
        const Decomposition fit = decompose(y.segment(k * layout.step, layout.length), 64, options);
        for (std::size_t h = 0; h < 3; ++h) {
          const std::optional<std::size_t> at = fit.nearest(two_pi * 9.797 * static_cast<double>(h + 1));
          ASSERT_TRUE(at.has_value());
          frequency[h].add(fit.tone(*at, 0).frequency / two_pi);
          amplitude[h].add(fit.tone(*at, 0).amplitude);
        }
      }
      EXPECT_NEAR(frequency[0].mean(), 9.796872, 2e-5);
      EXPECT_NEAR(amplitude[0].mean(), 0.896984, 1e-4);
      EXPECT_NEAR(frequency[1].mean(), 19.593825, 1e-3);
      EXPECT_NEAR(amplitude[1].mean(), 0.018090, 1e-4);
      EXPECT_NEAR(frequency[2].mean(), 29.392829, refine ? 2e-3 : 0.05);
      if (refine) {
        EXPECT_NEAR(amplitude[2].mean(), 0.001359, 4e-5);
      }
    }
  }
}

TEST(DecompositionStatistical, PeakOfTheTransformAsInTable43) {
  // The printed q of the transform's row has the sign of its imaginary part, opposite to that of Eq. (4.3).
  const VectorXd y = shaker_record(66, 48).head(1024);
  const SpectrumPeak primary = spectrum_peak(y, 64, two_pi * 9.797), second = spectrum_peak(y, 64, two_pi * 19.69);
  EXPECT_NEAR(primary.frequency / two_pi, 9.8125, 1e-9);
  EXPECT_NEAR(primary.p, 0.805861, 2e-3);
  EXPECT_NEAR(primary.q, -0.036122, 2e-3);
  EXPECT_NEAR(second.frequency / two_pi, 19.625, 1e-9);
  EXPECT_NEAR(second.p, -0.003412, 5e-4);
  EXPECT_NEAR(second.q, -0.010855, 5e-4);
}

// v'' + 2 mu v' + w^2 v + alpha v^3 = (direct + parametric v) cos(drive t): excitation and acceleration, settled.
struct Motion {
  VectorXd excitation, acceleration;
};
Motion driven(double w, double drive, double direct, double parametric) {
  constexpr double rate = 512, mu = 0.5;
  constexpr int inner = 16;
  const double alpha = 480, h = 1 / (rate * inner);
  const Index settle = static_cast<Index>(40 * rate), n = 1024;
  Motion motion{VectorXd(n), VectorXd(n)};
  double v = 0.01, s = 0;
  const auto slope = [&](double t, double x, double y) {
    return (direct + parametric * x) * std::cos(drive * t) - 2 * mu * y - w * w * x - alpha * x * x * x;
  };
  for (Index i = 0; i < settle + n; ++i) {
    const double start = static_cast<double>(i) / rate;
    if (i >= settle) {
      motion.excitation(i - settle) = std::cos(drive * start);
      motion.acceleration(i - settle) = slope(start, v, s);
    }
    for (int k = 0; k < inner; ++k) {
      const double t = start + k * h;
      const double k1 = s, l1 = slope(t, v, s);
      const double k2 = s + h / 2 * l1, l2 = slope(t + h / 2, v + h / 2 * k1, s + h / 2 * l1);
      const double k3 = s + h / 2 * l2, l3 = slope(t + h / 2, v + h / 2 * k2, s + h / 2 * l2);
      const double k4 = s + h * l3, l4 = slope(t + h, v + h * k3, s + h * l3);
      v += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      s += h / 6 * (l1 + 2 * l2 + 2 * l3 + l4);
    }
  }
  return motion;
}

TEST(DecompositionStatistical, InputAndOutputCorrelateInPrimaryButNotInParametricResonance) {
  // Figs. C.2 and C.4, second mode near 33 Hz, noise at 80 dB.
  testing_support::Gaussian random(49);
  const double w = two_pi * 33;
  Motion primary = driven(w, w, 0.4 * w, 0), parametric = driven(w, 2 * w, 0.5, 4 * w);
  for (Motion* motion : {&primary, &parametric}) {
    const double rms = std::sqrt(motion->acceleration.squaredNorm() / 1024);
    ASSERT_GT(rms, 0.1 * w * w * 0.7);  // it moves
    motion->acceleration += 1e-4 * rms * random.vector(1024);
  }
  constexpr int orders = 9;
  EXPECT_GT(input_output_correlation(primary.excitation, primary.acceleration, orders, orders), 0.9);
  EXPECT_LT(input_output_correlation(parametric.excitation, parametric.acceleration, orders, orders), 0.01);
  const MatrixXd one = delayed_correlation(primary.excitation, primary.acceleration, orders, orders);
  const MatrixXd two = delayed_correlation(parametric.excitation, parametric.acceleration, orders, orders);
  EXPECT_GT(one.topRightCorner(10, 10).cwiseAbs().maxCoeff(), 0.9);
  EXPECT_LT(two.topRightCorner(10, 10).cwiseAbs().maxCoeff(), 0.1);
  EXPECT_GT(two.topLeftCorner(10, 10).cwiseAbs().mean(), 0.4);  // each correlates with itself
}

}  // namespace
}  // namespace secular
