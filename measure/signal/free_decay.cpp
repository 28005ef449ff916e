#include "measure/signal/free_decay.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "measure/signal/circular_hyperbolic.hpp"
#include "measure/signal/tone_fit.hpp"
#include "measure/signal/tone_separation.hpp"
#include "measure/thresholds.hpp"
#include "numerics/hertz.hpp"
#include "numerics/median.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Crossings of `level` from `first` on, with hysteresis against noise, interpolated between samples.
std::vector<double> crossings(const Eigen::Ref<const VectorXd>& y, double level, double hysteresis, Index first) {
  std::vector<double> times;
  int side = 0;
  Index last_opposite = first;
  for (Index i = first; i < y.size(); ++i) {
    const double x = y(i) - level;
    const int here = x > hysteresis ? 1 : (x < -hysteresis ? -1 : 0);
    if (here == 0) continue;
    if (side != 0 && here != side) {
      // The sign change lies between the last sample beyond the band on the other side and this one.
      Index low = last_opposite;
      for (Index j = last_opposite; j < i; ++j)
        if ((y(j) - level) * side > 0) low = j;
      const double a = y(low) - level, b = y(low + 1) - level;
      times.push_back(static_cast<double>(low) + (a == b ? 0 : a / (a - b)));
    }
    side = here;
    last_opposite = i;
  }
  return times;
}

/// Samples, in two turns or more: what a tone with three harmonics, a growing amplitude and a sweeping frequency
/// needs, and one in three to spare.
constexpr Index shortest_window = 16;

/// Half periods that follow the largest excursion: two turns are what a tone is fitted over. A swing of twice as
/// many has later ones to compare them with: it is looked for in both directions before a shorter one is taken for
/// it.
constexpr std::size_t fewest_halves = 4, halves_at_first = 2 * fewest_halves;

/// Of the largest excursion, what counts as large as that.
constexpr auto& as_large = measure_thresholds().as_large;

/// Samples in half a turn: three harmonics lie below half the sample rate. Noise crosses its level every other
/// sample.
constexpr double shortest_half = 3;

}  // namespace

double decomposed_frequency(const Eigen::Ref<const VectorXd>& samples, double rate, double expected) {
  const double per_period = rate * two_pi / expected;
  const auto block = std::max<Index>(1, static_cast<Index>(per_period / 16));
  const Index count = samples.size() / block;
  constexpr int order = 3;
  if (count < 4 * order) return expected;
  VectorXd reduced(count);
  for (Index i = 0; i < count; ++i) reduced(i) = samples.segment(i * block, block).mean();
  reduced.array() -= reduced.mean();
  const CircularHyperbolicFit fit =
      circular_hyperbolic_decomposition(reduced, rate / static_cast<double>(block), order);
  // As near as what counts as near, or as the samples resolve: crossings in two turns tell no more than half a bin.
  const double bin = two_pi * rate / static_cast<double>(samples.size()) / expected;
  const double reach = std::max(measure_thresholds().largest_detuning, half_a_bin * bin);
  double best = expected, largest = 0;
  const auto consider = [&](double frequency, double power) {
    if (std::abs(frequency / expected - 1) > reach || power <= largest) return;
    largest = power;
    best = frequency;
  };
  for (const CircularTerm& term : fit.circular) consider(term.frequency, std::hypot(term.p, term.q));
  for (const ProductTerm& term : fit.products) consider(term.frequency, std::hypot(term.e, term.f));
  return best;
}

namespace {

// A swing that follows the largest excursion, for so many half periods.
struct Swing {
  DecayStart start;
  std::size_t halves = 0;
};

std::optional<Swing> decay_after_release(const Eigen::Ref<const VectorXd>& samples, double rate) {
  if (samples.size() < 64) return std::nullopt;
  // A first level from the last quarter, where the motion is small; the whole-record mean would be pulled by a
  // hold.
  const Index quarter = samples.size() / 4;
  std::vector<double> tail(samples.data() + samples.size() - quarter, samples.data() + samples.size());
  const double level = upper_median(std::move(tail));
  const double largest = (samples.array() - level).abs().maxCoeff();
  if (largest <= 0) return std::nullopt;
  Index last_large = 0;
  for (Index i = 0; i < samples.size(); ++i)
    if (std::abs(samples(i) - level) >= as_large * largest) last_large = i;
  const std::vector<double> zeros =
      crossings(samples, level, measure_thresholds().zero_level * largest, last_large);
  if (zeros.size() <= fewest_halves) return std::nullopt;
  std::vector<double> halves;
  for (std::size_t i = 0; i + 1 < std::min<std::size_t>(zeros.size(), 13); ++i)
    halves.push_back(zeros[i + 1] - zeros[i]);
  const double half_period = upper_median(halves);
  const double frequency = std::numbers::pi * rate / half_period;
  if (half_period <= shortest_half) return std::nullopt;
  const Index window = std::max(static_cast<Index>(4 * half_period), shortest_window);
  const auto residual = [&](double start) {
    const auto from = static_cast<Index>(start);
    if (from + window > samples.size()) return 0.0;
    ToneOptions options;
    options.harmonics = {1, 2, 3};
    options.fit_growth = true;
    options.fit_sweep = true;
    const ToneFit fit = fit_harmonic_tone(samples.segment(from, window), rate, frequency, options);
    return fit.noise_sd(0) / std::max(1e-300, std::abs(fit.amplitude(0, 0)));
  };
  std::size_t first = 0;
  std::vector<double> later;
  for (std::size_t i = 4; i + 4 < std::min<std::size_t>(zeros.size(), 16); i += 2)
    later.push_back(residual(zeros[i]));
  if (!later.empty()) {
    const double usual = std::max(upper_median(later), 1e-6);
    while (first < 6 && first + 8 < zeros.size() &&
           residual(zeros[first]) > measure_thresholds().disturbed_end * usual)
      ++first;
  }
  const auto start = static_cast<Index>(std::ceil(zeros[first]));
  if (start + window > samples.size()) return std::nullopt;
  return Swing{{start, decomposed_frequency(samples.segment(start, window), rate, frequency)}, zeros.size() - 1};
}

// A short swing whose largest excursions lie in its first turn and in its last one: over many turns no structure
// loses as little, and hum does.
std::optional<DecayStart> swing_that_keeps_its_size(const Eigen::Ref<const VectorXd>& samples, double rate) {
  if (samples.size() < 64) return std::nullopt;
  const double level = samples.mean(), largest = (samples.array() - level).abs().maxCoeff();
  const std::vector<double> zeros = crossings(samples, level, measure_thresholds().zero_level * largest, 0);
  if (zeros.size() <= fewest_halves || zeros.size() > 2 * halves_at_first) return std::nullopt;
  const double half = (zeros.back() - zeros.front()) / static_cast<double>(zeros.size() - 1);
  const auto turn = static_cast<Index>(2 * half);
  const auto reaches = [&](const auto& part) { return ((part.array() - level).abs() >= as_large * largest).any(); };
  if (half <= shortest_half || !reaches(samples.head(turn)) || !reaches(samples.tail(turn))) return std::nullopt;
  const Index window = std::min(samples.size(), std::max(2 * turn, shortest_window));
  return DecayStart{0, decomposed_frequency(samples.head(window), rate, std::numbers::pi * rate / half)};
}

}  // namespace

std::optional<DecayStart> find_decay_start(const Eigen::Ref<const VectorXd>& samples, double rate) {
  const auto released = decay_after_release(samples, rate);
  if (released && released->halves >= halves_at_first) return released->start;
  // A motion that grows to its largest excursion is a decay backwards, and free from the record's first sample on.
  const VectorXd backwards = samples.reverse();
  const auto grown = decay_after_release(backwards, rate);
  if (released && !(grown && grown->halves >= halves_at_first)) return released->start;
  if (grown) return DecayStart{0, grown->start.frequency};
  return swing_that_keeps_its_size(samples, rate);
}

}  // namespace secular
