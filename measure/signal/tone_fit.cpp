#include "measure/signal/tone_fit.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <stdexcept>
#include <utility>

#include "measure/thresholds.hpp"

namespace secular {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

ArrayXd centred_times(Index samples, double rate) {
  const double half = 0.5 * static_cast<double>(samples - 1) / rate;
  return ArrayXd::LinSpaced(samples, -half, half);
}

// Nonlinear unknowns, scaled by powers of the half window so that all are of the order of radians.
struct Poles {
  double frequency = 0, growth = 0, sweep = 0, growth_rate = 0;
};

class HarmonicTone {
 public:
  HarmonicTone(const Eigen::Ref<const MatrixXd>& channels, double rate, const ToneOptions& options)
      : y_(channels), options_(options), t_(centred_times(channels.rows(), rate)) {
    half_ = std::max(std::abs(t_(0)), 1 / rate);
    unknowns_ = 1 + (options.fit_growth ? 1 : 0) + (options.fit_sweep ? 2 : 0);
    linear_ = 2 * static_cast<Index>(options.harmonics.size()) + (options.offset ? 1 : 0);
    if (channels.rows() <= linear_ + unknowns_ + 1)
      throw std::invalid_argument("fewer samples than unknowns of a tone");
    if (!channels.allFinite()) throw std::invalid_argument("samples of a tone that are not finite");
  }

  ToneFit fit(double frequency) {
    Poles poles{frequency, 0, 0, 0};
    Projection now = project(poles);
    ToneFit result;
    result.samples = y_.rows();
    result.ending = SolverEnding::stalled;
    double damping = 1e-3;
    for (int iteration = 0; iteration < 60; ++iteration) {
      const auto [gradient, hessian] = normal_equations(now);
      MatrixXd damped = hessian;
      damped.diagonal() *= 1 + damping;
      const VectorXd step = damped.ldlt().solve(VectorXd(-gradient));
      if (!step.allFinite()) {
        result.ending = SolverEnding::ran_away;
        break;
      }
      const Poles next = moved(poles, step);
      Projection candidate = project(next);
      if (candidate.cost <= now.cost) {
        const double gain = now.cost - candidate.cost;
        poles = next;
        now = std::move(candidate);
        damping = std::max(damping / 10, 1e-12);
        if (step.norm() < 1e-11 || gain <= 1e-13 * now.cost) {
          result.ending = SolverEnding::converged;
          break;
        }
      } else {
        damping *= 10;
        if (damping > 1e8) {
          // No descent is left: at the minimum to rounding.
          result.ending = SolverEnding::converged;
          break;
        }
      }
    }
    finish(poles, now, result);
    return result;
  }

 private:
  struct Projection {
    MatrixXd basis;  // samples x linear unknowns
    Eigen::HouseholderQR<MatrixXd> qr;
    MatrixXd coefficients;  // linear unknowns x channels
    MatrixXd residual;      // samples x channels
    VectorXd weight;        // 1/variance per channel
    double cost = 0;        // sum of log variances: the likelihood with unknown levels
    std::vector<Eigen::ArrayXcd> waves;
  };

  Poles moved(Poles poles, const VectorXd& step) const {
    Index i = 0;
    poles.frequency += step(i++) / half_;
    if (options_.fit_growth) poles.growth += step(i++) / half_;
    if (options_.fit_sweep) {
      poles.sweep += step(i++) * 2 / (half_ * half_);
      poles.growth_rate += step(i++) * 2 / (half_ * half_);
    }
    return poles;
  }

  Projection project(const Poles& poles) const {
    Projection p;
    p.basis.resize(y_.rows(), linear_);
    const Eigen::ArrayXcd exponent =
        (std::complex<double>(poles.growth, poles.frequency) * t_.cast<std::complex<double>>()) +
        std::complex<double>(poles.growth_rate, poles.sweep) * (0.5 * t_.square()).cast<std::complex<double>>();
    Index column = 0;
    for (const int harmonic : options_.harmonics) {
      p.waves.push_back((static_cast<double>(harmonic) * exponent).exp());
      p.basis.col(column++) = 2 * p.waves.back().real();
      p.basis.col(column++) = -2 * p.waves.back().imag();
    }
    if (options_.offset) p.basis.col(column).setOnes();
    p.qr.compute(p.basis);
    p.coefficients = p.qr.solve(y_);
    p.residual = y_ - p.basis * p.coefficients;
    p.weight.resize(y_.cols());
    const auto n = static_cast<double>(y_.rows());
    for (Index c = 0; c < y_.cols(); ++c) {
      const double floor = 1e-30 * (y_.col(c).squaredNorm() / n) + 1e-300;
      const double variance = p.residual.col(c).squaredNorm() / n + floor;
      p.weight(c) = 1 / variance;
      p.cost += std::log(variance);
    }
    return p;
  }

  // Derivative of the prediction of one channel with respect to the scaled unknowns, before projection.
  MatrixXd sensitivities(const Projection& p, Index channel) const {
    MatrixXd result = MatrixXd::Zero(y_.rows(), unknowns_);
    for (std::size_t h = 0; h < options_.harmonics.size(); ++h) {
      const auto row = static_cast<Index>(2 * h);
      const std::complex<double> amplitude(p.coefficients(row, channel), p.coefficients(row + 1, channel));
      const Eigen::ArrayXcd wave = p.waves[h] * (amplitude * (2.0 * static_cast<double>(options_.harmonics[h])));
      const ArrayXd linear = t_ / half_, square = linear.square();
      Index i = 0;
      result.col(i++).array() -= linear * wave.imag();
      if (options_.fit_growth) result.col(i++).array() += linear * wave.real();
      if (options_.fit_sweep) {
        result.col(i++).array() -= square * wave.imag();
        result.col(i++).array() += square * wave.real();
      }
    }
    return result;
  }

  // Kaufman's form of variable projection: sensitivities made orthogonal to the basis.
  std::pair<VectorXd, MatrixXd> normal_equations(const Projection& p) const {
    VectorXd gradient = VectorXd::Zero(unknowns_);
    MatrixXd hessian = MatrixXd::Zero(unknowns_, unknowns_);
    for (Index c = 0; c < y_.cols(); ++c) {
      MatrixXd free = sensitivities(p, c);
      free -= p.basis * MatrixXd(p.qr.solve(free));
      gradient -= p.weight(c) * (free.transpose() * p.residual.col(c));
      hessian += p.weight(c) * (free.transpose() * free);
    }
    return {gradient, hessian};
  }

  void finish(const Poles& poles, const Projection& p, ToneFit& result) const {
    result.frequency = poles.frequency;
    result.growth = poles.growth;
    result.sweep = poles.sweep;
    result.growth_rate = poles.growth_rate;
    const auto [gradient, hessian] = normal_equations(p);
    // Degrees of freedom: the shared poles are counted once.
    const auto n = static_cast<double>(y_.rows());
    const double lost =
        static_cast<double>(linear_) + static_cast<double>(unknowns_) / static_cast<double>(y_.cols());
    const double correction = n / (n - lost);
    const MatrixXd covariance =
        correction * hessian.ldlt().solve(MatrixXd(MatrixXd::Identity(unknowns_, unknowns_)));
    result.frequency_sd = std::sqrt(std::max(0.0, covariance(0, 0))) / half_;
    if (options_.fit_growth) result.growth_sd = std::sqrt(std::max(0.0, covariance(1, 1))) / half_;
    const auto harmonics = static_cast<Index>(options_.harmonics.size());
    result.amplitude.resize(harmonics, y_.cols());
    result.amplitude_sd.resize(harmonics, y_.cols());
    result.offset = VectorXd::Zero(y_.cols());
    result.noise_sd.resize(y_.cols());
    const MatrixXd inverse =
        MatrixXd(p.basis.transpose() * p.basis).ldlt().solve(MatrixXd(MatrixXd::Identity(linear_, linear_)));
    for (Index c = 0; c < y_.cols(); ++c) {
      const double variance = correction / p.weight(c);
      result.noise_sd(c) = std::sqrt(variance);
      const MatrixXd drag = p.qr.solve(sensitivities(p, c));
      const MatrixXd whole = variance * inverse + drag * covariance * drag.transpose();
      for (Index h = 0; h < harmonics; ++h) {
        result.amplitude(h, c) = {p.coefficients(2 * h, c), p.coefficients(2 * h + 1, c)};
        result.amplitude_sd(h, c) =
            std::sqrt(std::max(0.0, 0.5 * (whole(2 * h, 2 * h) + whole(2 * h + 1, 2 * h + 1))));
      }
      if (options_.offset) result.offset(c) = p.coefficients(linear_ - 1, c);
    }
  }

  const Eigen::Ref<const MatrixXd>& y_;
  const ToneOptions& options_;
  ArrayXd t_;
  double half_ = 1;
  Index unknowns_ = 1, linear_ = 2;
};

}  // namespace

ToneFit fit_harmonic_tone(const Eigen::Ref<const MatrixXd>& channels, double sample_rate_hz, double frequency,
                          const ToneOptions& options) {
  if (options.harmonics.empty()) throw std::invalid_argument("a tone without harmonics");
  return HarmonicTone(channels, sample_rate_hz, options).fit(frequency);
}

KnownFrequencyFit known_frequency_components(const Eigen::Ref<const MatrixXd>& channels, double sample_rate_hz,
                                             std::span<const double> frequencies, bool offset) {
  const auto count = static_cast<Index>(frequencies.size());
  const Index linear = 2 * count + (offset ? 1 : 0);
  if (channels.rows() <= linear) throw std::invalid_argument("fewer samples than unknown components");
  const ArrayXd t = centred_times(channels.rows(), sample_rate_hz);
  MatrixXd basis(channels.rows(), linear);
  for (Index f = 0; f < count; ++f) {
    const double frequency = frequencies[static_cast<std::size_t>(f)];
    basis.col(2 * f) = 2 * (frequency * t).cos();
    basis.col(2 * f + 1) = -2 * (frequency * t).sin();
  }
  if (offset) basis.col(linear - 1).setOnes();
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(basis);
  const MatrixXd coefficients = qr.solve(channels);
  const MatrixXd residual = channels - basis * coefficients;
  const MatrixXd inverse =
      MatrixXd(basis.transpose() * basis).ldlt().solve(MatrixXd(MatrixXd::Identity(linear, linear)));
  KnownFrequencyFit fit;
  fit.amplitude.resize(count, channels.cols());
  fit.amplitude_sd.resize(count, channels.cols());
  fit.offset =
      offset ? VectorXd(coefficients.row(linear - 1).transpose()) : VectorXd(VectorXd::Zero(channels.cols()));
  fit.noise_sd.resize(channels.cols());
  for (Index c = 0; c < channels.cols(); ++c) {
    fit.noise_sd(c) = std::sqrt(residual.col(c).squaredNorm() / static_cast<double>(channels.rows() - linear));
    for (Index f = 0; f < count; ++f) {
      fit.amplitude(f, c) = {coefficients(2 * f, c), coefficients(2 * f + 1, c)};
      fit.amplitude_sd(f, c) =
          fit.noise_sd(c) * std::sqrt(0.5 * (inverse(2 * f, 2 * f) + inverse(2 * f + 1, 2 * f + 1)));
    }
  }
  return fit;
}

double least_amplitude_sd() {
  return std::sqrt(-2 * std::log(measure_thresholds().motion_false_alarm));
}

}  // namespace secular
