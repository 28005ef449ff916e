#include "motion/correction/harmonic_excess.hpp"

#include <Eigen/Dense>
#include <algorithm>
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

// An estimate is within this many standard deviations of the truth, 95 times in 100.
constexpr double longest_step = 2;

// Of one dwell: in units of the largest motion, as channels show both.
struct ExcessOfOne {
  bool known = false;
  int multiple = 0;
  double motion = 0;                  // the largest, as channels show it
  double measured = 0, expected = 0;  // moduli
  Complex left = 0;
  double sd = 0;                     // of a real part of what is left
  std::vector<Complex> of_estimate;  // what steps of the estimate within its error bars make of it
  std::vector<double> of_open;       // and those along what it leaves open, moduli
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
    const std::vector<std::vector<Complex>> changes = changes_of_prediction(o);
    const auto open = along_what_is_open(o);
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
      const double unit = std::pow(std::abs(f), derivatives_) / own;
      ExcessOfOne& e = result[b];
      e = {.known = true,
           .multiple = static_cast<int>(std::lround(ratio)),
           .motion = own,
           .measured = std::abs(o.harmonic[b]) * unit,
           .expected = std::abs(*with) * unit,
           .left = (o.harmonic[b] - *with) * unit,
           .sd = std::hypot(o.harmonic_sd[b], by_line * o.forcing_harmonic_sd[b]) * unit,
           .of_estimate = {},
           .of_open = {}};
      for (const std::vector<Complex>& change : changes) e.of_estimate.push_back(change[b] * unit);
      for (const auto& moved : open) {
        const auto there = moved ? motions_.amplitude_of(mode, block.phase, *moved) : std::nullopt;
        e.of_open.push_back(there ? std::abs(*there - *without) * unit : INFINITY);
      }
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

  // By step of the estimate within its error bars, by block: by the expansion, which these steps are known to move.
  std::vector<std::vector<Complex>> changes_of_prediction(const Observation& o) const {
    const auto at = [&](const VectorXd& parameters) {
      return predicted_harmonics(*set_.model, *set_.resonance, parameters, o);
    };
    const std::vector<Complex> here = at(estimate_.parameter_values);
    std::vector<std::vector<Complex>> changes;
    for (const Eigen::MatrixXd* steps : {&estimate_.noise, &estimate_.open})
      for (const auto& step : steps->colwise()) {
        changes.push_back(at(estimate_.parameter_values + step));
        for (std::size_t b = 0; b < here.size(); ++b) changes.back()[b] -= here[b];
      }
    return changes;
  }

  // Along each direction that the campaign leaves open: by the full equations, since no lump of the expansion
  // notices it. Motions without a balance there are as unknown as any.
  std::vector<std::optional<BalancedMotions::Balanced>> along_what_is_open(const Observation& o) const {
    std::vector<std::optional<BalancedMotions::Balanced>> motions;
    for (const auto& step : estimate_.null_space.colwise())
      motions.push_back(motions_.in_balance(estimate_.parameter_values + step, o));
    return motions;
  }

  const ObservationSet& set_;
  const Estimate& estimate_;
  int derivatives_;
  BalancedMotions motions_;
};

// What is left of dwells where the estimate takes the steps within its error bars that leave least: all dwells are
// predicted by one estimate.
void take_estimate_off(std::vector<ExcessOfOne>& dwells) {
  const auto steps = static_cast<Index>(dwells.front().of_estimate.size());
  if (steps == 0) return;
  const auto rows = 2 * static_cast<Index>(dwells.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(rows + steps, steps);
  VectorXd target = VectorXd::Zero(rows + steps);
  for (Index i = 0; i < rows / 2; ++i) {
    const ExcessOfOne& e = dwells[static_cast<std::size_t>(i)];
    target(2 * i) = e.left.real() / e.sd;
    target(2 * i + 1) = e.left.imag() / e.sd;
    for (Index d = 0; d < steps; ++d) {
      const Complex change = e.of_estimate[static_cast<std::size_t>(d)] / e.sd;
      matrix(2 * i, d) = change.real();
      matrix(2 * i + 1, d) = change.imag();
    }
  }
  matrix.bottomRows(steps).setIdentity();
  VectorXd step = matrix.colPivHouseholderQr().solve(target);
  if (const double longest = step.cwiseAbs().maxCoeff(); longest > longest_step) step *= longest_step / longest;
  for (ExcessOfOne& e : dwells)
    for (Index d = 0; d < steps; ++d) e.left -= step(d) * e.of_estimate[static_cast<std::size_t>(d)];
}

// How much of an excess counts: all of it where the estimate determines the prediction, none of it where a step
// along what it leaves open moves the prediction by more than noise.
double determined(const std::vector<ExcessOfOne>& dwells) {
  double most = 0;
  for (std::size_t d = 0; d < dwells.front().of_open.size(); ++d) {
    double moved = 0;
    for (const ExcessOfOne& e : dwells) moved += std::pow(e.of_open[d] / e.sd, 2) / 2;
    most = std::max(most, moved / static_cast<double>(dwells.size()));
  }
  return std::max(0.0, 1 - most);
}

// docs/inference.md (56).
std::optional<HarmonicExcess> excess_of_block(const std::vector<std::vector<ExcessOfOne>>& all, std::size_t block) {
  std::vector<ExcessOfOne> dwells;
  for (const std::vector<ExcessOfOne>& one : all)
    if (const ExcessOfOne& e = one[block];
        e.known && e.sd > 0 && (dwells.empty() || e.multiple == dwells.front().multiple))
      dwells.push_back(e);
  if (dwells.empty()) return std::nullopt;
  take_estimate_off(dwells);
  HarmonicExcess sum{.block = block, .multiple = dwells.front().multiple};
  double squares = 0, weights = 0, chi_squared = 0;
  for (const ExcessOfOne& e : dwells) {
    const double weight = std::pow(e.motion, 4);
    weights += weight;
    sum.measured += weight * e.measured * e.measured;
    sum.expected += weight * e.expected * e.expected;
    squares += weight * std::norm(e.left);
    chi_squared += std::norm(e.left) / (e.sd * e.sd);
  }
  const double by_chance = chi_squared_upper_quantile(estimator_thresholds().contradiction_alarm,
                                                      2 * static_cast<double>(dwells.size()));
  const double counts = determined(dwells) * (1 - by_chance / chi_squared);
  if (!(counts > 0)) return std::nullopt;
  sum.measured = std::sqrt(sum.measured / weights);
  sum.expected = std::sqrt(sum.expected / weights);
  sum.share = std::sqrt(squares / weights * counts);
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
