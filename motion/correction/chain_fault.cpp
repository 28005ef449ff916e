#include "motion/correction/chain_fault.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "estimator/model/zero_frequency.hpp"
#include "measure/observe/modal_projection.hpp"
#include "measure/observe/observed_blocks.hpp"
#include "measure/observe/record_ranges.hpp"
#include "motion/correction/equal_poles.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;

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
void take_poles_off_rates(const EqualPoles& filter, std::span<Observation> windows) {
  for (std::size_t k = 0; k < windows.front().rate.size(); ++k) {
    const Eigen::VectorXd growth = growth_of_frequency(windows, k);
    for (std::size_t i = 0; i < windows.size(); ++i) {
      std::complex<double>& rate = windows[i].rate[k];
      rate += filter.slope_of_inverse(rate.imag()) * growth(static_cast<Eigen::Index>(i));
    }
  }
}

// By how much the mean that a decay's windows show in `block` grows with the square of the amplitude. Zero where
// too few windows show it.
double growth_of_mean(std::span<const Observation> windows, std::size_t block) {
  constexpr Eigen::Index fewest = 3;
  double largest = 0;
  std::vector<const Observation*> seen;
  for (const Observation& o : windows) {
    if (!(o.harmonic_sd[block] > 0)) continue;
    seen.push_back(&o);
    largest = std::max(largest, std::norm(o.amplitude.front()));
  }
  const auto count = static_cast<Eigen::Index>(seen.size());
  if (count < fewest || !(largest > 0)) return 0;
  Eigen::MatrixXd matrix(count, 2);
  Eigen::VectorXd target(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Observation& o = *seen[static_cast<std::size_t>(i)];
    matrix.row(i) << 1, std::norm(o.amplitude.front()) / largest;
    matrix.row(i) /= o.harmonic_sd[block];
    target(i) = o.harmonic[block].real() / o.harmonic_sd[block];
  }
  return Eigen::VectorXd(matrix.colPivHouseholderQr().solve(target))(1) / largest;
}

// Takes a factor 1 + g off the motion, where g is as the square of the amplitude: rates see that as well.
void take_factor_off(Complex g, Observation& o) {
  o.amplitude.front() *= 1.0 - g;
  o.rate.front() -= 2 * o.rate.front().real() * g;
}

// What a law of the sensor makes of the lines of the one mode of a set. docs/inference.md (61).
class SensorLaw {
 public:
  SensorLaw(const SizedFault& fault, const CompiledCase& resonance)
      : fault_(fault),
        resonance_(resonance),
        even_(fault.kind == ChainFault::even_law),
        k_(fault.size / (even_ ? fault.largest : fault.largest * fault.largest)) {}

  void take_off(std::span<Observation> windows) const {
    const double mean = growth_of_means(windows);
    for (Observation& o : windows) even_ ? take_even_off(o, mean - 2 * k_) : take_cubic_off(o, mean);
  }

 private:
  Complex motion_of(const Observation& o) const {
    return o.amplitude.front() * derived(o.rate.front().imag(), fault_.derivatives);
  }

  // Of displacements, which alone have a mean that moves: that of the motion and of the law.
  double growth_of_means(std::span<const Observation> windows) const {
    for (std::size_t b = 0; fault_.derivatives == 0 && b < resonance_.blocks.size(); ++b)
      if (is_zero_frequency(resonance_.blocks[b])) return growth_of_mean(windows, b);
    return 0;
  }

  // `line`: in the channels' quantity, at a multiple of the motion's frequency, off that line where it was
  // measured.
  void take_off_line(Observation& o, int multiple, Complex line) const {
    line /= derived(multiple * o.rate.front().imag(), fault_.derivatives);
    for_lines_at_multiple(resonance_, 0, multiple, o,
                          [&](Complex& seen, bool reversed) { seen -= reversed ? std::conj(line) : line; });
  }

  // In the channels' quantity; zero where it was not measured.
  Complex second_harmonic(const Observation& o) const {
    Complex second = 0;
    for_lines_at_multiple(resonance_, 0, 2, o, [&](const Complex& seen, bool reversed) {
      second = (reversed ? std::conj(seen) : seen) * derived(2 * o.rate.front().imag(), fault_.derivatives);
    });
    return second;
  }

  // `growth`: of the motion's own mean with the square of the amplitude.
  void take_even_off(Observation& o, double growth) const {
    const Complex motion = motion_of(o);
    const double square = std::norm(motion);
    if (!(square > 0)) return;
    take_off_line(o, 2, k_ * motion * motion);
    const Complex second = second_harmonic(o);
    const double mean = 2 * k_ * (mean_square(o, fault_.derivatives) + std::norm(second));
    if (fault_.shows_mean && !o.mean.empty()) o.mean.front() -= mean;
    for (std::size_t b = 0; fault_.derivatives == 0 && fault_.shows_mean && b < o.harmonic.size(); ++b)
      if (o.harmonic_sd[b] >= 0 && is_zero_frequency(resonance_.blocks[b])) o.harmonic[b] -= mean;
    take_off_line(o, 3, 2 * k_ * motion * second);
    take_factor_off(2 * k_ * (growth * square + std::conj(motion) * second / motion), o);
  }

  void take_cubic_off(Observation& o, double growth) const {
    const Complex motion = motion_of(o);
    const double square = std::norm(motion);
    take_off_line(o, 3, k_ * motion * motion * motion);
    take_off_line(o, 2, 3 * k_ * square * (2.0 * second_harmonic(o) + growth * motion * motion));
    take_factor_off(3 * k_ * square, o);
  }

  const SizedFault& fault_;
  const CompiledCase& resonance_;
  bool even_;
  double k_;
};

}  // namespace

EqualPoles SizedFault::filter() const {
  EqualPoles result;
  result.frequency = frequency;
  result.poles = poles;
  result.high_pass = kind == ChainFault::high_pass;
  const double angle = result.high_pass ? size / poles : std::sqrt(size / poles);  // w tau, or 1/(w tau)
  result.late_s = poles * std::atan(angle) / frequency;
  return result;
}

double mean_square(const Observation& window, int derivatives) {
  const std::complex<double> rate = window.rate.front();
  const double fall = rate.real() * window.length_s;  // |A|^2 is as exp(2 fall t/T), from t = -T/2 to T/2
  return std::norm(window.amplitude.front() * derived(rate.imag(), derivatives)) *
         (std::abs(fall) > 1e-4 ? std::sinh(fall) / fall : 1);
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
  if (is_filter(fault.kind)) {
    const EqualPoles filter = fault.filter();
    std::vector<ObservationSet> before = before_poles(sets, filter);
    for (std::size_t s = 0; s < before.size(); ++s) {
      if (before[s].resonance->excited) continue;
      for (const RecordRange& range : ranges_of_records(before[s].observations))
        take_poles_off_rates(filter,
                             std::span(before[s].observations).subspan(range.begin, range.end - range.begin));
    }
    return before;
  }
  std::vector<ObservationSet> result(sets.begin(), sets.end());
  for (ObservationSet& set : result) {
    const SensorLaw law(fault, *set.resonance);
    for (const RecordRange& range : ranges_of_records(set.observations))
      law.take_off(std::span(set.observations).subspan(range.begin, range.end - range.begin));
  }
  return result;
}

}  // namespace secular
