#include "measure/signal/decomposition.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "measure/signal/refine_poles.hpp"
#include "measure/signal/tone_search.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Column-scaled least squares with rank, amplitudes at the centre of the window; NaN where a rate takes a function
// beyond all numbers.
MatrixXd linear_amplitudes(const MatrixXd& functions, const Eigen::Ref<const MatrixXd>& channels) {
  if (functions.cols() == 0) return MatrixXd(0, channels.cols());  // a polynomial without roots: one sample of many
  const VectorXd scale =
      functions.colwise().norm().cwiseMax(std::numeric_limits<double>::min()).cwiseInverse().transpose();
  const MatrixXd scaled = functions * scale.asDiagonal();
  if (!scaled.allFinite())
    return MatrixXd::Constant(functions.cols(), channels.cols(), std::numeric_limits<double>::quiet_NaN());
  return scale.asDiagonal() * MatrixXd(scaled.colPivHouseholderQr().solve(channels));
}

std::vector<Pole> known_poles(const DecompositionOptions& options) {
  std::vector<Pole> poles;
  if (options.offset) poles.push_back({PoleFamily::constant, 0, 0, true});
  for (const double frequency : options.imposed) poles.push_back({PoleFamily::circular, frequency, 0, true});
  return poles;
}

// Moves the origin of time by `shift` seconds, the covariance with it.
void move_origin(Decomposition& d, PoleCovariance& covariance, double shift) {
  Index function = 0;
  for (const Pole& pole : d.poles) {
    const Index size = function_count(pole);
    d.amplitudes.middleRows(function, size) =
        (shift_matrix(pole, shift) * d.amplitudes.middleRows(function, size)).eval();
    function += size;
  }
  covariance.move_origin(d.poles, d.amplitudes, shift);
}

void set_quality(Decomposition& d, const Eigen::Ref<const MatrixXd>& channels, const MatrixXd& residual) {
  const auto n = static_cast<double>(channels.rows());
  const double lost = static_cast<double>(function_count(d.poles)) +
                      static_cast<double>(parameter_count(d.poles)) / static_cast<double>(channels.cols());
  d.correlation.resize(channels.cols());
  d.signal_to_noise_db.resize(channels.cols());
  d.noise_sd.resize(channels.cols());
  for (Index c = 0; c < channels.cols(); ++c) {
    const VectorXd model = channels.col(c) - residual.col(c);
    const double left = residual.col(c).squaredNorm(), power = model.squaredNorm();
    const double product = channels.col(c).dot(model), both = channels.col(c).squaredNorm() * power;
    d.correlation(c) = both > 0 ? product * product / both : 0;
    d.signal_to_noise_db(c) = left > 0 ? 10 * std::log10(power / left) : std::numeric_limits<double>::infinity();
    d.noise_sd(c) = std::sqrt(left / std::max(1.0, n - lost));
  }
}

RefinedPoles refined(const Eigen::Ref<const MatrixXd>& channels, double rate, const std::vector<Pole>& poles,
                     const DecompositionOptions& options) {
  RefinedPoles best = refine_poles(channels, rate, poles);
  const double unknowns = static_cast<double>(function_count(poles)) +
                          static_cast<double>(parameter_count(poles)) / static_cast<double>(channels.cols());
  const bool spurious = !best.covariance.determined;
  if (!spurious && spectral_peak(best.residual, rate, 1, unknowns).probability > 1e-3) return best;
  ToneSearchOptions search;
  search.max_tones = options.order;
  search.false_alarm = 1;
  search.beside = known_poles(options);
  RefinedPoles rival = search_tones(channels, rate, search).fit;
  return rival.cost < best.cost ? rival : best;
}

// Unknown poles by family and frequency, then those that were known; all within [0, Nyquist].
std::vector<Pole> in_order(std::vector<Pole> poles, double rate) {
  for (Pole& pole : poles) {
    pole.rate = std::abs(pole.rate);
    pole.frequency = std::abs(pole.frequency);
    if (!pole.imposed && pole.frequency > std::numbers::pi * rate)
      pole.frequency = std::abs(two_pi * rate - pole.frequency);
  }
  std::stable_sort(poles.begin(), poles.end(), [](const Pole& a, const Pole& b) {
    if (a.imposed != b.imposed) return b.imposed;
    if (a.imposed) return false;
    return a.family != b.family         ? a.family < b.family
           : a.frequency != b.frequency ? a.frequency < b.frequency
                                        : a.rate < b.rate;
  });
  return poles;
}

}  // namespace

MatrixXd Decomposition::reconstruct(Index count) const {
  return pole_functions(poles, count, sample_rate_hz, -origin_s) * amplitudes;
}

Index Decomposition::first_function(std::size_t pole) const {
  return function_count(std::span<const Pole>(poles.data(), pole));
}

Index Decomposition::first_parameter(std::size_t pole) const {
  return parameter_count(std::span<const Pole>(poles.data(), pole));
}

Index Decomposition::amplitude_row(Index function, Index channel) const {
  return parameter_count(poles) + channel * amplitudes.rows() + function;
}

ToneEstimate Decomposition::tone(std::size_t pole, Index channel) const {
  if (pole >= poles.size() || poles[pole].family != PoleFamily::circular)
    throw std::invalid_argument("amplitude and phase of a pole that is not circular");
  const Index row = first_function(pole);
  const double p = amplitudes(row, channel), q = amplitudes(row + 1, channel);
  ToneEstimate tone;
  tone.frequency = poles[pole].frequency;
  tone.amplitude = std::hypot(p, q);
  tone.phase = std::atan2(-q, p);
  tone.frequency_sd = tone.amplitude_sd = tone.phase_sd = std::numeric_limits<double>::quiet_NaN();
  if (covariance.size() == 0) return tone;
  const Index at = amplitude_row(row, channel);
  const Eigen::Matrix2d block = covariance.block<2, 2>(at, at);
  const Eigen::Vector2d along(p / tone.amplitude, q / tone.amplitude);
  const Eigen::Vector2d across(q / tone.amplitude, -p / tone.amplitude);
  tone.frequency_sd = poles[pole].imposed ? 0 : std::sqrt(covariance(first_parameter(pole), first_parameter(pole)));
  tone.amplitude_sd = std::sqrt(along.dot(block * along));
  tone.phase_sd = std::sqrt(across.dot(block * across)) / tone.amplitude;
  return tone;
}

std::optional<std::size_t> Decomposition::nearest(double frequency) const {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < poles.size(); ++i) {
    if (poles[i].family != PoleFamily::circular) continue;
    if (!best || std::abs(poles[i].frequency - frequency) < std::abs(poles[*best].frequency - frequency)) best = i;
  }
  return best;
}

Decomposition decompose(const Eigen::Ref<const MatrixXd>& channels, double sample_rate_hz,
                        const DecompositionOptions& options) {
  if (!std::isfinite(channels.squaredNorm()))
    throw std::invalid_argument("circular-hyperbolic decomposition of samples whose squares are not finite");
  std::vector<double> imposed;
  if (options.offset) imposed.push_back(0);
  for (const double frequency : options.imposed) imposed.push_back(frequency / sample_rate_hz);
  const SymmetricPolynomial polynomial =
      estimate_symmetric_polynomial(channels, options.order, imposed, options.method);
  if (!polynomial.determined) {
    Decomposition none;
    none.determined = false;
    none.sample_rate_hz = sample_rate_hz;
    none.samples = channels.rows();
    return none;
  }
  std::vector<Pole> poles = poles_of(polynomial.free);
  for (Pole& pole : poles) {
    pole.frequency *= sample_rate_hz;
    pole.rate *= sample_rate_hz;
  }
  for (const Pole& pole : known_poles(options)) poles.push_back(pole);

  Decomposition d;
  d.sample_rate_hz = sample_rate_hz;
  d.samples = channels.rows();
  const double centre = 0.5 * static_cast<double>(channels.rows() - 1) / sample_rate_hz;
  PoleCovariance covariance;
  bool done = false;
  if (options.refine) {
    RefinedPoles fit = refined(channels, sample_rate_hz, poles, options);
    d.refinement = fit.ending;
    d.iterations = fit.iterations;
    if (std::isfinite(fit.cost)) {
      // The order of the poles is settled by a last call on sorted poles, which moves nothing.
      const std::vector<Pole> sorted = in_order(fit.poles, sample_rate_hz);
      bool same = true;
      for (std::size_t i = 0; i < sorted.size(); ++i)
        same = same && sorted[i].family == fit.poles[i].family && sorted[i].frequency == fit.poles[i].frequency &&
               sorted[i].rate == fit.poles[i].rate && sorted[i].imposed == fit.poles[i].imposed;
      if (!same) fit = refine_poles(channels, sample_rate_hz, sorted);
      d.poles = std::move(fit.poles);
      d.amplitudes = std::move(fit.amplitudes);
      covariance = std::move(fit.covariance);
      set_quality(d, channels, fit.residual);
      done = true;
    }
  }
  if (!done) {
    d.poles = std::move(poles);
    const MatrixXd functions = pole_functions(d.poles, channels.rows(), sample_rate_hz, -centre);
    d.amplitudes = linear_amplitudes(functions, channels);
    set_quality(d, channels, channels - functions * d.amplitudes);
  }
  move_origin(d, covariance, options.origin_s - centre);
  if (done) d.covariance = covariance.matrix();
  d.origin_s = options.origin_s;
  return d;
}

}  // namespace secular
