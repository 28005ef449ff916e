#include "motion/correction/chain_fault.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>

#include "estimator/model/zero_frequency.hpp"
#include "measure/observe/modal_projection.hpp"
#include "measure/observe/observed_blocks.hpp"
#include "measure/observe/record_ranges.hpp"
#include "motion/correction/low_pass.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;

/// Lines at a multiple of a frequency are there to this, relative.
constexpr double same_line = 1e-3;

// By how much the frequency of a mode grows in a second in each of a decay's windows, rad/s^2: that of the
// likeliest frequency of second degree in the squared amplitude, by the measured rates.
Eigen::VectorXd growth_of_frequency(std::span<const Observation> windows, std::size_t mode) {
  const auto count = static_cast<Eigen::Index>(windows.size());
  double largest = 0;
  for (const Observation& o : windows) largest = std::max(largest, std::norm(o.amplitude[mode]));
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count, 3);
  Eigen::VectorXd target = Eigen::VectorXd::Zero(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Observation& o = windows[static_cast<std::size_t>(i)];
    if (o.growth_sd[mode] < 0 || !(o.frequency_sd[mode] > 0)) continue;
    const double square = std::norm(o.amplitude[mode]) / largest;
    matrix.row(i) << 1, square, square * square;
    matrix.row(i) /= o.frequency_sd[mode];
    target(i) = (o.rate[mode].imag() - windows.front().rate[mode].imag()) / o.frequency_sd[mode];
  }
  const Eigen::VectorXd law = matrix.colPivHouseholderQr().solve(target);
  Eigen::VectorXd growth(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Observation& o = windows[static_cast<std::size_t>(i)];
    const double square = std::norm(o.amplitude[mode]) / largest;
    growth(i) = 2 * o.rate[mode].real() * square * (law(1) + 2 * law(2) * square);
  }
  return growth;
}

// What poles take off depends on the frequency, which an amplitude that falls moves: rates see that, too.
void take_poles_off_rates(const LowPass& filter, std::span<Observation> windows) {
  for (std::size_t k = 0; k < windows.front().rate.size(); ++k) {
    const Eigen::VectorXd growth = growth_of_frequency(windows, k);
    for (std::size_t i = 0; i < windows.size(); ++i) {
      std::complex<double>& rate = windows[i].rate[k];
      const Complex pole(0, filter.time_constant());
      const Complex slope = static_cast<double>(filter.poles) * pole / (1.0 + pole * rate.imag()) -
                            Complex(0, std::abs(filter.late_s));
      rate += slope * growth(static_cast<Eigen::Index>(i));
    }
  }
}

// Of the one mode of a set, what a law of the sensor makes of its lines. docs/inference.md (61).
void take_law_off(const SizedFault& fault, const CompiledCase& resonance, Observation& o) {
  const int d = fault.derivatives;
  const bool even = fault.kind == ChainFault::even_law;
  const double k = fault.size / (even ? fault.largest : fault.largest * fault.largest);
  const double own = o.rate.front().imag();
  const Complex motion = o.amplitude.front() * derived(own, d);
  const double square = std::norm(motion);
  for (std::size_t b = 0; b < o.harmonic.size(); ++b) {
    const RegressorBlock& block = resonance.blocks[b];
    if (!(o.harmonic_sd[b] >= 0)) continue;
    if (even && d == 0 && is_zero_frequency(block)) o.harmonic[b] -= 2 * k * square;
    const int order = even ? 2 : 3;
    const double f = block_frequency(block, o);
    if (std::abs(std::abs(f) / own - order) > same_line) continue;
    const Complex line = k * std::pow(motion, order) / derived(order * own, d);
    o.harmonic[b] -= f < 0 ? std::conj(line) : line;
  }
  if (even && !o.mean.empty()) o.mean.front() -= 2 * k * square;
  if (!even) o.amplitude.front() *= 1 - 3 * k * square;
}

}  // namespace

double SizedFault::time_constant() const {
  return std::sqrt(size / poles) / frequency;
}

double SizedFault::amplitude() const {
  return std::pow(1 + size / poles, -0.5 * poles);
}

int multiple_of(const RegressorBlock& block) {
  int multiple = 0;
  for (std::size_t i = 0; i < block.phase.size(); ++i) {
    if (block.phase[i] == 0) continue;
    if (multiple != 0 || static_cast<int>(i) != block.mode) return 0;
    multiple = block.phase[i];
  }
  return multiple;
}

std::vector<ObservationSet> without_fault(std::span<const ObservationSet> sets, const SizedFault& fault) {
  if (fault.kind == ChainFault::low_pass) {
    LowPass filter;
    filter.frequency = fault.frequency;
    filter.poles = fault.poles;
    filter.late_s = fault.poles * std::atan(fault.frequency * fault.time_constant()) / fault.frequency;
    std::vector<ObservationSet> before = before_low_pass(sets, filter);
    for (std::size_t s = 0; s < before.size(); ++s) {
      if (before[s].resonance->excited) continue;
      for (const RecordRange& range : ranges_of_records(before[s].observations))
        take_poles_off_rates(filter,
                             std::span(before[s].observations).subspan(range.begin, range.end - range.begin));
    }
    return before;
  }
  std::vector<ObservationSet> result(sets.begin(), sets.end());
  for (ObservationSet& set : result)
    for (Observation& o : set.observations) take_law_off(fault, *set.resonance, o);
  return result;
}

}  // namespace secular
