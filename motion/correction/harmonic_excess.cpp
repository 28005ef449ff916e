#include "motion/correction/harmonic_excess.hpp"

#include <Eigen/Core>
#include <cmath>
#include <optional>

#include "estimator/identification/predicted_harmonics.hpp"
#include "estimator/model/block_frequency.hpp"
#include "estimator/thresholds.hpp"
#include "motion/correction/balanced_motions.hpp"
#include "motion/correction/mean_motion.hpp"
#include "numerics/distribution.hpp"
#include "numerics/in_parallel.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::VectorXd;

// Of one dwell: in units of the largest motion, as channels show both.
struct ExcessOfOne {
  bool known = false;
  int multiple = 0;
  double motion = 0;                            // the largest, as channels show it
  double measured = 0, expected = 0, left = 0;  // moduli
  double sd = 0;                                // of a real part of what is left
};

class ExcessOfCase {
 public:
  ExcessOfCase(const ObservationSet& set, const Estimate& estimate, int derivatives)
      : set_(set), estimate_(estimate), derivatives_(derivatives), motions_(*set.model, *set.resonance) {}

  bool known() const { return set_.resonance->excited && motions_.known(); }

  // By block.
  std::vector<ExcessOfOne> of(std::span<const Observation> ensembles) const {
    const Observation o = mean_of(ensembles);
    std::vector<ExcessOfOne> result(set_.resonance->blocks.size());
    const std::optional<std::size_t> largest = largest_motion(o);
    if (!largest || o.forcing_harmonic.empty()) return result;
    const VectorXd& parameters = estimate_.parameter_values;
    const auto whole = motions_.under_all_lines(parameters, o), plain = motions_.in_balance(parameters, o);
    if (!whole || !plain) return result;
    const std::vector<double> error = errors_of_prediction(o);
    const double own = shown(o.amplitude[*largest], o.rate[*largest].imag());
    for (std::size_t b = 0; b < result.size(); ++b) {
      const RegressorBlock& block = set_.resonance->blocks[b];
      if (block.kind != BlockKind::harmonic || !(o.harmonic_sd[b] >= 0) || !(o.forcing_harmonic_sd[b] >= 0))
        continue;
      const double f = block_frequency(block, [&](std::size_t i) {
        return i < o.rate.size() ? o.rate[i].imag() : o.excitation_frequency[i - o.rate.size()];
      });
      const double ratio = std::abs(f) / o.rate[*largest].imag();
      if (ratio < 1.5 || std::abs(ratio - std::round(ratio)) > 1e-3) continue;
      const auto mode = static_cast<std::size_t>(block.mode);
      const auto with = motions_.amplitude_of(mode, block.phase, *whole),
                 without = motions_.amplitude_of(mode, block.phase, *plain);
      if (!with || !without) continue;
      const double by_line =
          std::abs(o.forcing_harmonic[b]) > 0 ? std::abs(*with - *without) / std::abs(o.forcing_harmonic[b]) : 0.0;
      const double sd = std::hypot(o.harmonic_sd[b], by_line * o.forcing_harmonic_sd[b], error[b]);
      result[b] = {.known = true,
                   .multiple = static_cast<int>(std::lround(ratio)),
                   .motion = own,
                   .measured = shown(o.harmonic[b], f) / own,
                   .expected = shown(*with, f) / own,
                   .left = shown(o.harmonic[b] - *with, f) / own,
                   .sd = shown(sd, f) / own};
    }
    return result;
  }

 private:
  // What ensembles of a dwell agree on, harmonics with it, at the phases of the first.
  Observation mean_of(std::span<const Observation> ensembles) const {
    Observation mean = mean_motion(ensembles, *set_.model, *set_.resonance);
    const Observation& first = ensembles.front();
    if (first.forcing_harmonic.empty()) return mean;
    const auto count = static_cast<double>(ensembles.size());
    for (std::size_t b = 0; b < mean.harmonic.size(); ++b) {
      Complex harmonic = 0, forcing = 0;
      double squares = 0, squares_of_forcing = 0;
      bool seen = true;
      for (const Observation& o : ensembles) {
        seen = seen && o.harmonic_sd[b] >= 0 && o.forcing_harmonic_sd[b] >= 0;
        const Complex back = std::polar(1.0, -turned(set_.resonance->blocks[b], o, first));
        harmonic += o.harmonic[b] * back / count;
        forcing += o.forcing_harmonic[b] * back / count;
        squares += std::pow(o.harmonic_sd[b] / count, 2);
        squares_of_forcing += std::pow(o.forcing_harmonic_sd[b] / count, 2);
      }
      mean.harmonic[b] = harmonic;
      mean.harmonic_sd[b] = seen ? std::sqrt(squares) : -1;
      mean.forcing_harmonic[b] = forcing;
      mean.forcing_harmonic_sd[b] = seen ? std::sqrt(squares_of_forcing) : -1;
    }
    return mean;
  }

  // By how much further the phase of a block's line is in one ensemble than in another.
  static double turned(const RegressorBlock& block, const Observation& o, const Observation& first) {
    double sum = 0;
    for (std::size_t i = 0; i < block.phase.size(); ++i) {
      if (block.phase[i] == 0) continue;
      const std::size_t modes = o.amplitude.size();
      const Complex to = i < modes ? o.amplitude[i] : o.forcing[i - modes],
                    from = i < modes ? first.amplitude[i] : first.forcing[i - modes];
      sum += block.phase[i] * std::arg(to * std::conj(from));
    }
    return sum;
  }

  // A displacement as channels show it.
  double shown(Complex displacement, double frequency) const {
    return std::abs(displacement) * std::pow(std::abs(frequency), derivatives_);
  }

  std::optional<std::size_t> largest_motion(const Observation& o) const {
    std::optional<std::size_t> found;
    double most = 0;
    for (std::size_t k = 0; k < o.amplitude.size(); ++k)
      if (const double size = shown(o.amplitude[k], o.rate[k].imag()); size > most) {
        most = size;
        found = k;
      }
    return found;
  }

  // By block: what the estimate's error bars leave open of a real part.
  std::vector<double> errors_of_prediction(const Observation& o) const {
    const auto at = [&](const VectorXd& parameters) {
      return predicted_harmonics(*set_.model, *set_.resonance, parameters, o);
    };
    const std::vector<Complex> here = at(estimate_.parameter_values);
    std::vector<double> square(here.size(), 0);
    for (const Eigen::MatrixXd* directions : {&estimate_.noise, &estimate_.open})
      for (const auto& step : directions->colwise()) {
        const std::vector<Complex> there = at(estimate_.parameter_values + step);
        for (std::size_t b = 0; b < here.size(); ++b) square[b] += std::norm(there[b] - here[b]) / 2;
      }
    for (double& s : square) s = std::sqrt(s);
    return square;
  }

  const ObservationSet& set_;
  const Estimate& estimate_;
  int derivatives_;
  BalancedMotions motions_;
};

// docs/inference.md (55).
std::optional<HarmonicExcess> excess_of_block(const std::vector<std::vector<ExcessOfOne>>& all, std::size_t block) {
  HarmonicExcess sum{.block = block};
  double squares = 0, weights = 0, chi_squared = 0, count = 0;
  for (const std::vector<ExcessOfOne>& one : all) {
    const ExcessOfOne& e = one[block];
    if (!e.known || !(e.sd > 0) || (sum.multiple != 0 && e.multiple != sum.multiple)) continue;
    sum.multiple = e.multiple;
    const double weight = std::pow(e.motion, 4);
    weights += weight;
    sum.measured += weight * e.measured * e.measured;
    sum.expected += weight * e.expected * e.expected;
    squares += weight * e.left * e.left;
    chi_squared += std::pow(e.left / e.sd, 2);
    ++count;
  }
  if (count == 0) return std::nullopt;
  const double by_chance = chi_squared_upper_quantile(estimator_thresholds().contradiction_alarm, 2 * count);
  if (!(chi_squared > by_chance)) return std::nullopt;
  sum.measured = std::sqrt(sum.measured / weights);
  sum.expected = std::sqrt(sum.expected / weights);
  sum.share = std::sqrt(squares / weights * (1 - by_chance / chi_squared));
  return sum;
}

}  // namespace

std::vector<HarmonicExcess> harmonic_excess(std::span<const ObservationSet> measured, const Estimate& estimate,
                                            int derivatives, unsigned threads) {
  std::vector<HarmonicExcess> found;
  for (const ObservationSet& set : measured) {
    const ExcessOfCase of_case(set, estimate, derivatives);
    if (!of_case.known()) continue;
    std::vector<std::span<const Observation>> dwells;
    for (std::size_t begin = 0, end = 0; begin < set.observations.size(); begin = end) {
      while (end < set.observations.size() && set.observations[end].record == set.observations[begin].record) ++end;
      dwells.push_back(std::span(set.observations).subspan(begin, end - begin));
    }
    std::vector<std::vector<ExcessOfOne>> all(dwells.size());
    in_parallel(all.size(), threads, [&](std::size_t i) { all[i] = of_case.of(dwells[i]); });
    for (std::size_t b = 0; b < set.resonance->blocks.size(); ++b)
      if (auto excess = excess_of_block(all, b)) {
        excess->resonance = set.resonance;
        found.push_back(*excess);
      }
  }
  return found;
}

}  // namespace secular
