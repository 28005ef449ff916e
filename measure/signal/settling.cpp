#include "measure/signal/settling.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <stdexcept>

#include "measure/signal/tone_fit.hpp"
#include "numerics/confidence.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Polynomial trend over ensembles at x = -1 ... 1 and the variance of its coefficients under overlap.
struct Trend {
  VectorXd coefficients;
  MatrixXd covariance;
  double variance = 0;  // of one ensemble about the trend
  double degrees_of_freedom = 0;
};

Trend trend_of(const VectorXd& values, const EnsembleLayout& layout, int degree) {
  const Index count = values.size(), unknowns = degree + 1;
  const VectorXd x = VectorXd::LinSpaced(count, -1, 1);
  MatrixXd design(count, unknowns), correlation(count, count);
  for (Index j = 0; j < unknowns; ++j) design.col(j) = x.array().pow(static_cast<double>(j));
  for (Index i = 0; i < count; ++i)
    for (Index j = 0; j < count; ++j) correlation(i, j) = ensemble_correlation(layout, std::abs(i - j));
  const MatrixXd inverse =
      MatrixXd(design.transpose() * design).ldlt().solve(MatrixXd(MatrixXd::Identity(unknowns, unknowns)));
  const MatrixXd pseudo = inverse * design.transpose();
  const MatrixXd keep = MatrixXd::Identity(count, count) - design * pseudo;
  const MatrixXd seen = keep * correlation;
  Trend trend;
  trend.coefficients = pseudo * values;
  const double expected = seen.trace();
  trend.variance = (keep * values).squaredNorm() / expected;
  trend.covariance = trend.variance * (pseudo * correlation * pseudo.transpose());
  trend.degrees_of_freedom = expected * expected / (seen * seen).trace();
  return trend;
}

bool significant(double value, double sd, double freedom, double false_alarm) {
  if (!(sd > 0)) return value != 0;
  return two_sided_p_value(value / sd, std::max(1.0, freedom)) < false_alarm;
}

std::string sentence(Index tone, Index channel, const char* what, double value, const char* unit) {
  char text[160];
  std::snprintf(text, sizeof text, "tone %td of channel %td: %s changes by %.3g%s over the record",
                static_cast<std::ptrdiff_t>(tone + 1), static_cast<std::ptrdiff_t>(channel + 1), what, value, unit);
  return text;
}

}  // namespace

SettlingReport check_settling(const std::vector<MatrixXcd>& amplitude, const std::vector<MatrixXd>& amplitude_sd,
                              const EnsembleLayout& layout, bool free_frequency, const SettlingOptions& options) {
  const auto count = static_cast<Index>(amplitude.size());
  if (count < 4 || amplitude_sd.size() != amplitude.size())
    throw std::invalid_argument("a check of settling needs four ensembles or more, and their standard deviations");
  const Index tones = amplitude.front().rows(), channels = amplitude.front().cols();
  const double each = options.false_alarm / static_cast<double>(2 * tones * channels);
  SettlingReport report;
  for (Index c = 0; c < channels; ++c) {
    for (Index tone = 0; tone < tones; ++tone) {
      VectorXd logarithm(count), phase(count), own(count);
      double last = 0;
      for (Index k = 0; k < count; ++k) {
        const auto i = static_cast<std::size_t>(k);
        const Complex value = amplitude[i](tone, c);
        logarithm(k) = std::log(std::max(std::abs(value), 1e-300));
        last += std::remainder(std::arg(value) - last, two_pi);  // unwrapped
        phase(k) = last;
        own(k) = std::pow(amplitude_sd[i](tone, c) / std::max(std::abs(value), 1e-300), 2);
      }
      const Trend grown = trend_of(logarithm, layout, 1);
      const int turn = free_frequency ? 2 : 1;
      const Trend turned = trend_of(phase, layout, turn);
      ToneDrift drift;
      drift.amplitude_trend = 2 * grown.coefficients(1);
      drift.amplitude_trend_sd = 2 * std::sqrt(grown.covariance(1, 1));
      // A bend from the middle to the ends, or a slope from end to end.
      const double span = turn == 2 ? 1 : 2;
      drift.phase_trend = span * turned.coefficients(turn);
      drift.phase_trend_sd = span * std::sqrt(turned.covariance(turn, turn));
      drift.scatter_ratio = own.mean() > 0 ? grown.variance / own.mean() : 0;
      // A trend must also stand above the errors that the fits themselves report.
      const double reported = 2 * std::sqrt(own.mean() * grown.covariance(1, 1) / std::max(grown.variance, 1e-300));
      const bool amplitude_moved =
          std::abs(drift.amplitude_trend) > options.largest_drift &&
          std::abs(drift.amplitude_trend) > 3 * reported &&
          significant(drift.amplitude_trend, drift.amplitude_trend_sd, grown.degrees_of_freedom, each);
      const bool phase_moved =
          std::abs(drift.phase_trend) > options.largest_phase_drift &&
          significant(drift.phase_trend, drift.phase_trend_sd, turned.degrees_of_freedom, each);
      drift.settled = !amplitude_moved && !phase_moved;
      if (!drift.settled && report.settled)
        report.reason = amplitude_moved ? sentence(tone, c, "amplitude", 100 * drift.amplitude_trend, " %")
                                        : sentence(tone, c, "phase", drift.phase_trend, " rad");
      report.settled = report.settled && drift.settled;
      report.tones.push_back(drift);
    }
  }
  return report;
}

SettlingReport check_settling(const Eigen::Ref<const MatrixXd>& channels, double sample_rate_hz,
                              const std::vector<double>& frequencies, const EnsembleLayout& layout,
                              bool free_frequency, const SettlingOptions& options) {
  std::vector<MatrixXcd> amplitude;
  std::vector<MatrixXd> amplitude_sd;
  for (Index k = 0; k < layout.count; ++k) {
    KnownFrequencyFit fit = known_frequency_components(channels.middleRows(k * layout.step, layout.length),
                                                       sample_rate_hz, frequencies, true);
    const double centre = static_cast<double>(k * layout.step) / sample_rate_hz;
    for (Index f = 0; f < fit.amplitude.rows(); ++f)
      fit.amplitude.row(f) *=
          std::exp(Complex(0, -std::remainder(frequencies[static_cast<std::size_t>(f)] * centre, two_pi)));
    amplitude.push_back(fit.amplitude);
    amplitude_sd.push_back(fit.amplitude_sd);
  }
  return check_settling(amplitude, amplitude_sd, layout, free_frequency, options);
}

}  // namespace secular
