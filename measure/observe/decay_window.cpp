#include "measure/observe/decay_window.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "estimator/model/zero_frequency.hpp"
#include "measure/observe/record_window.hpp"
#include "measure/signal/slow_tones.hpp"
#include "measure/signal/tone_separation.hpp"
#include "measure/thresholds.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Of the amplitudes in time.
constexpr int degree = 2;

/// exp(-f u), u from -1/2 to 1/2, leaves f^3/6 u^3 beside the second degree, of which u^3 has 1/20 of Legendre's
/// third polynomial in 2u, whose mean square is 1/7.
constexpr double beyond_second_degree = 1 / (6 * 20 * 2.6457513110645906);

/// Bins between two tones for which the length of windows is chosen, and of a tone from a constant at zero
/// frequency. Tones may be nearer by half a bin: frequencies are not known beforehand.
constexpr double chosen_bins = bins_between(degree, degree), bins_from_constant = bins_between(degree, 0),
                 separate_bins = chosen_bins - half_a_bin;

/// A harmonic that is nearer than this to a mode's tone, over the lowest frequency, is detuned from it by what a
/// resonance is; it does not lengthen the windows: where they do not separate it, it is left out.
constexpr auto& near_harmonic = measure_thresholds().largest_detuning;

/// Steps to the frequency at the window's centre; each leaves the square of its distance in bins.
constexpr int frequency_steps = 6;

// From the measured quantity, the d-th derivative of a displacement B(tau) exp(w tau), back to it: with Y its
// amplitude, B = (w + D)^-d Y = w^-d (1 - d/w D + d(d+1)/2/w^2 D^2 ...) Y, D the derivative with respect to tau.
struct Integration {
  Complex value, slope, curvature;
  Integration(Complex w, double d)
      : value(std::pow(w, -d)), slope(-d * value / w), curvature(0.5 * d * (d + 1) * value / (w * w)) {}
};

}  // namespace

DecayWindows::DecayWindows(const Campaign& campaign, const CompiledModel& model, const CompiledCase& resonance,
                           const Window& window)
    : model_(model), resonance_(resonance), projection_(modal_projection(campaign, model)), window_(window) {
  const ModeFrequencies modes = mode_frequencies(model, resonance);
  for (std::size_t k = 0; k < model.modes(); ++k)
    if (modes.oscillates[k]) oscillating_.push_back(k);
  for (const RegressorBlock& block : resonance.blocks) rectifies_ = rectifies_ || is_zero_frequency(block);
}

MatrixXd DecayWindows::modal_samples(const Record& record, Index first, Index count) const {
  return samples_of(record, projection_.channels, first, count) * projection_.matrix.transpose();
}

std::vector<int> DecayWindows::own_phase(std::size_t mode) const {
  std::vector<int> phase(model_.modes(), 0);
  phase[mode] = 1;
  return phase;
}

std::vector<int> DecayWindows::block_phase(std::size_t block) const {
  const auto& phase = resonance_.blocks[block].phase;
  return {phase.begin(), phase.begin() + static_cast<std::ptrdiff_t>(model_.modes())};
}

double DecayWindows::frequency_of(const std::vector<int>& phase, const VectorXd& frequency) const {
  double sum = 0;
  for (std::size_t k = 0; k < phase.size(); ++k) sum += phase[k] * frequency(static_cast<Index>(k));
  return sum;
}

// Up to sign and up to a multiple of a resonance relation.
bool DecayWindows::same(const std::vector<int>& a, const std::vector<int>& b) const {
  const std::size_t modes = model_.modes(), width = modes + model_.excitations.size();
  for (const int sign : {1, -1}) {
    std::vector<int> difference(modes);
    for (std::size_t k = 0; k < modes; ++k) difference[k] = a[k] - sign * b[k];
    const auto is_zero = [](const std::vector<int>& v) {
      return std::all_of(v.begin(), v.end(), [](int x) { return x == 0; });
    };
    if (is_zero(difference)) return true;
    for (std::size_t r = 0; r + width <= resonance_.relations.size(); r += width)
      for (const int multiple : {-2, -1, 1, 2}) {
        std::vector<int> reduced = difference;
        for (std::size_t k = 0; k < modes; ++k) reduced[k] += multiple * resonance_.relations[r + k];
        if (is_zero(reduced)) return true;
      }
  }
  return false;
}

double DecayWindows::shortest_s(const VectorXd& frequency, double rate) const {
  double lowest = INFINITY, distance = INFINITY;
  for (const std::size_t k : oscillating_) lowest = std::min(lowest, frequency(static_cast<Index>(k)));
  distance = lowest * (rectifies_ ? 1 : chosen_bins / bins_from_constant);
  std::size_t count = oscillating_.size();
  for (const std::size_t k : oscillating_) {
    const double own = frequency(static_cast<Index>(k));
    for (const std::size_t other : oscillating_)
      if (!same(own_phase(other), own_phase(k)))
        distance = std::min(distance, std::abs(own - frequency(static_cast<Index>(other))));
    for (std::size_t b = 0; b < resonance_.blocks.size(); ++b) {
      const RegressorBlock& block = resonance_.blocks[b];
      if (block.kind != BlockKind::harmonic || block.order > 1 || same(block_phase(b), own_phase(k))) continue;
      const double apart = std::abs(std::abs(frequency_of(block_phase(b), frequency)) - own);
      if (apart > near_harmonic * lowest) distance = std::min(distance, apart);
    }
  }
  count += resonance_.blocks.size();
  // Samples for twice the unknowns at least.
  return std::max(chosen_bins * two_pi / distance,
                  2.0 * (2 * static_cast<double>(count) + 1) * (degree + 1) / rate);
}

DecayWindows::Tones DecayWindows::tones(const VectorXd& frequency, double seconds, double rate) const {
  const double bin = two_pi / seconds, nyquist = std::numbers::pi * rate;
  Tones result;
  std::vector<std::vector<int>> phases;
  result.of_mode.assign(model_.modes(), -1);
  result.of_block.assign(resonance_.blocks.size(), -1);
  result.reversed.assign(resonance_.blocks.size(), false);
  const auto index_of = [&](const std::vector<int>& phase, bool own) -> std::ptrdiff_t {
    for (std::size_t i = 0; i < phases.size(); ++i)
      if (same(phases[i], phase)) return static_cast<std::ptrdiff_t>(i);
    const double f = std::abs(frequency_of(phase, frequency));
    if (!own && (f < separate_bins * bin || f > nyquist - separate_bins * bin || !window_.passes(f))) return -1;
    for (const double other : result.frequency)
      if (!own && std::abs(other - f) < separate_bins * bin) return -1;
    phases.push_back(phase);
    result.frequency.push_back(f);
    return static_cast<std::ptrdiff_t>(phases.size()) - 1;
  };
  for (const std::size_t k : oscillating_) result.of_mode[k] = index_of(own_phase(k), true);
  for (const int order : {1, 2})
    for (std::size_t b = 0; b < resonance_.blocks.size(); ++b) {
      const RegressorBlock& block = resonance_.blocks[b];
      if (block.kind != BlockKind::harmonic || (block.order <= 1) != (order == 1)) continue;
      const std::vector<int> phase = block_phase(b);
      result.reversed[b] = frequency_of(phase, frequency) < 0;
      if (!is_zero_frequency(block)) result.of_block[b] = index_of(phase, false);
    }
  return result;
}

DecayWindow DecayWindows::fit(const MatrixXd& modal, double rate, VectorXd& frequency) const {
  const double seconds = static_cast<double>(modal.rows()) / rate;
  const int d = projection_.derivatives;
  DecayWindow window;
  Observation& o = window.observation;
  const std::size_t modes = model_.modes();
  const double noise = window_.noise_factor(rate);
  SlowToneFit seen;
  Tones list;
  const VectorXd expected = frequency;
  // A mode that moves further than to the next line of the shortest window is another motion or noise (what is slow
  // in an acceleration looks like a large displacement): it is not seen.
  const double reach = half_a_bin * two_pi / std::min(seconds, shortest_s(expected, rate));
  for (int step = 0; step < frequency_steps; ++step) {
    list = tones(frequency, seconds, rate);
    seen = fit_slow_tones(modal, rate, list.frequency, degree, rectifies_ ? degree : 0);
    for (MatrixXd& sd : seen.sd) sd *= noise;
    seen.offset_sd *= noise;
    o.amplitude.assign(modes, Complex());
    o.amplitude_sd.assign(modes, 0.0);
    o.rate.assign(modes, Complex());
    o.growth_sd.assign(modes, -1.0);
    o.frequency_sd.assign(modes, 0.0);
    window.bend = window.fall = 0;
    window.beyond_degree = VectorXd::Zero(static_cast<Index>(modes));
    double moved = 0;
    for (const std::size_t k : oscillating_) {
      const auto at = static_cast<Index>(k);
      const Index tone = list.of_mode[k];
      // Modes that an internal resonance locks to another's tone at this window keep their own frequency.
      const double w = list.frequency[static_cast<std::size_t>(tone)];
      const Complex y0 = seen.derivative[0](tone, at), y1 = seen.derivative[1](tone, at),
                    y2 = seen.derivative[2](tone, at);
      o.rate[k] = Complex(0, frequency(at));
      const Integration to({0, w}, d);
      o.amplitude_sd[k] = std::abs(to.value) * seen.sd[0](tone, at);
      if (2 * std::abs(y0) < measure_thresholds().seen_above_noise * seen.noise_sd(at)) continue;
      if (std::abs(frequency(at) - expected(at)) > reach) continue;
      o.amplitude[k] = to.value * y0 + to.slope * y1 + to.curvature * y2;
      const Complex slope = to.value * y1 + to.slope * y2, a = o.amplitude[k];
      o.rate[k] = Complex(0, w) + slope / a;
      o.growth_sd[k] = o.frequency_sd[k] = std::abs(to.value) * seen.sd[1](tone, at) / std::abs(a);
      const double size = std::abs(y0);
      window.bend = std::max(window.bend, (std::abs(y2) - 2 * seen.sd[2](tone, at)) / size * seconds * seconds / 8);
      window.fall = std::max(window.fall, (std::abs((y1 / y0).real()) - 2 * seen.sd[1](tone, at) / size) * seconds);
      window.beyond_degree(at) = std::numbers::sqrt2 * size * beyond_second_degree *
                                 std::pow(std::abs((y1 / y0).real()) * seconds, degree + 1);
      const double shift =
          std::clamp(o.rate[k].imag() - frequency(at), -0.25 * two_pi / seconds, 0.25 * two_pi / seconds);
      moved = std::max(moved, std::abs(shift) * seconds);
      if (step + 1 < frequency_steps) frequency(at) += shift;
    }
    if (moved < 1e-3) break;
  }
  for (const std::size_t k : oscillating_)
    if (o.growth_sd[k] < 0) frequency(static_cast<Index>(k)) = expected(static_cast<Index>(k));
  window.noise_sd = seen.noise_sd;
  window.degrees_of_freedom = static_cast<double>(seen.degrees_of_freedom);
  read_harmonics(seen, list, o);
  o.mean.assign(seen.offset.data(), seen.offset.data() + seen.offset.size());
  o.mean_sd.assign(seen.offset_sd.data(), seen.offset_sd.data() + seen.offset_sd.size());
  const std::size_t excitations = model_.excitations.size();
  o.excitation_frequency.assign(excitations, 0.0);
  o.excitation_frequency_sd.assign(excitations, 0.0);
  o.forcing.assign(excitations, Complex());
  o.forcing_sd.assign(excitations, 0.0);
  o.length_s = seconds;
  return window;
}

std::vector<WindowPair> DecayWindows::overlaps(Index samples, double rate, const VectorXd& frequency,
                                               int steps) const {
  const Tones list = tones(frequency, static_cast<double>(samples) / rate, rate);
  const SlowToneWeights weights = slow_tone_weights(samples, rate, list.frequency, degree, rectifies_ ? degree : 0);
  const auto count = static_cast<Index>(list.frequency.size());
  // What makes the displacement's amplitude and slope of the samples, over the phase of the first.
  Eigen::MatrixXcd amplitude(count, samples), slope(count, samples);
  for (Index j = 0; j < count; ++j) {
    const Integration to({0, list.frequency[static_cast<std::size_t>(j)]}, projection_.derivatives);
    const Complex first = to.slope / to.value, second = to.curvature / to.value;
    amplitude.row(j) =
        weights.derivative[0].row(j) + first * weights.derivative[1].row(j) + second * weights.derivative[2].row(j);
    slope.row(j) = weights.derivative[1].row(j) + first * weights.derivative[2].row(j);
  }
  std::vector<WindowPair> result;
  for (int n = 1; n < steps; ++n) {
    const Index shift = n * samples / steps, common = samples - shift;
    const auto correlation = [&](const Eigen::MatrixXcd& here, const Eigen::MatrixXcd& later, Index tone) {
      const Complex turn =
          std::polar(1.0, list.frequency[static_cast<std::size_t>(tone)] * static_cast<double>(shift) / rate);
      const Complex product =
          later.row(tone).head(common).conjugate().cwiseProduct(here.row(tone).tail(common)).sum();
      return (turn * product).real() / (here.row(tone).norm() * later.row(tone).norm());
    };
    WindowPair pair;
    pair.mode.resize(model_.modes());
    for (const std::size_t k : oscillating_) {
      const Index tone = list.of_mode[k];
      pair.mode[k] = {correlation(amplitude, amplitude, tone), correlation(slope, slope, tone),
                      correlation(amplitude, slope, tone), correlation(slope, amplitude, tone)};
    }
    for (std::size_t b = 0; b < resonance_.blocks.size(); ++b) {
      double& own = pair.harmonic.emplace_back(0);
      if (const Index tone = list.of_block[b]; tone >= 0)
        own = correlation(amplitude, amplitude, tone);
      else if (is_zero_frequency(resonance_.blocks[b]))
        own = weights.offset.head(common).dot(weights.offset.tail(common)) / weights.offset.squaredNorm();
    }
    result.push_back(std::move(pair));
  }
  return result;
}

void DecayWindows::read_harmonics(const SlowToneFit& seen, const Tones& list, Observation& o) const {
  for (std::size_t b = 0; b < resonance_.blocks.size(); ++b) {
    const RegressorBlock& block = resonance_.blocks[b];
    const auto at = static_cast<Index>(block.mode);
    Complex value = 0;
    double sd = -1;
    if (const Index tone = list.of_block[b]; tone >= 0) {
      const Integration to({0, list.frequency[static_cast<std::size_t>(tone)]}, projection_.derivatives);
      value = to.value * seen.derivative[0](tone, at) + to.slope * seen.derivative[1](tone, at) +
              to.curvature * seen.derivative[2](tone, at);
      if (list.reversed[b]) value = std::conj(value);
      sd = std::abs(to.value) * seen.sd[0](tone, at);
    } else if (is_zero_frequency(block) && projection_.derivatives == 0 && window_.passes(0)) {
      value = seen.offset(at);
      sd = seen.offset_sd(at);
    }
    o.harmonic.push_back(value);
    o.harmonic_sd.push_back(sd);
  }
}

Observation DecayWindows::fit_again(const Record& record, const Observation& like) const {
  const double rate = record.sample_rate_hz;
  const auto count = static_cast<Index>(std::lround(like.length_s * rate));
  const auto first = static_cast<Index>(
      std::lround((like.centre_s - record.start_s) * rate - 0.5 * static_cast<double>(count - 1)));
  VectorXd frequency(static_cast<Index>(like.rate.size()));
  for (Index k = 0; k < frequency.size(); ++k) frequency(k) = like.rate[static_cast<std::size_t>(k)].imag();
  return fit(modal_samples(record, first, count), rate, frequency).observation;
}

}  // namespace secular
