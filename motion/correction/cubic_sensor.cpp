#include "motion/correction/cubic_sensor.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "estimator/identification/beyond_chance.hpp"
#include "estimator/identification/predicted_harmonics.hpp"
#include "measure/observe/modal_projection.hpp"
#include "measure/observe/observed_blocks.hpp"
#include "measure/observe/record_ranges.hpp"
#include "motion/correction/balanced_motions.hpp"
#include "motion/correction/mean_motion.hpp"
#include "numerics/in_parallel.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::VectorXd;

// The third harmonic of one dwell, as a share of the motion, in the phase in which a cube of the motion has it.
struct ThirdHarmonic {
  double motion = 0;                // half amplitude, as channels show it
  double left = 0, sd = 0;          // what model and excitation do not make
  std::vector<double> of_estimate;  // what steps of the estimate within its error bars make of it
  std::vector<double> of_open;      // and those along what it leaves open, moduli
};

class ThirdHarmonics {
 public:
  ThirdHarmonics(const ObservationSet& set, const Estimate& estimate, int derivatives)
      : set_(set), estimate_(estimate), derivatives_(derivatives), motions_(*set.model, *set.resonance) {}

  bool known() const { return set_.resonance->excited && motions_.known(); }

  std::optional<ThirdHarmonic> of(std::span<const Observation> ensembles) const {
    if (ensembles.front().forcing_harmonic.empty()) return std::nullopt;
    const Observation o = mean_of(ensembles);
    const std::size_t mode = largest_mode(o);
    const double own = o.rate[mode].imag();
    const std::optional<std::size_t> b = block_of(o, mode);
    if (!b) return std::nullopt;
    const RegressorBlock& block = set_.resonance->blocks[*b];
    const VectorXd& parameters = estimate_.parameter_values;
    const auto whole = motions_.under_all_lines(parameters, o), plain = motions_.in_balance(parameters, o);
    if (!whole || !plain) return std::nullopt;
    const auto with = motions_.amplitude_of(mode, block.phase, *whole),
               without = motions_.amplitude_of(mode, block.phase, *plain);
    if (!with || !without) return std::nullopt;
    const Complex motion = o.amplitude[mode] * derived(own, derivatives_);
    const double f = block_frequency(block, o);
    // To the phase and in the unit of the motion's cube over its squared modulus.
    const Complex unit =
        derived(f, derivatives_) * std::pow(std::conj(motion) / std::abs(motion), 3) / std::abs(motion);
    const double by_line =
        std::abs(o.forcing_harmonic[*b]) > 0 ? std::abs(*with - *without) / std::abs(o.forcing_harmonic[*b]) : 0.0;
    ThirdHarmonic third{std::abs(motion),
                        ((o.harmonic[*b] - *with) * unit).real(),
                        std::hypot(o.harmonic_sd[*b], by_line * o.forcing_harmonic_sd[*b]) * std::abs(unit),
                        {},
                        {}};
    const Complex here = predicted(parameters, o, *b);
    for (const Eigen::MatrixXd* steps : {&estimate_.noise, &estimate_.open})
      for (const auto& step : steps->colwise())
        third.of_estimate.push_back(((predicted(parameters + step, o, *b) - here) * unit).real());
    // By the full equations, since no lump of the expansion notices these. Motions without a balance there are as
    // unknown as any.
    for (const auto& step : estimate_.null_space.colwise()) {
      const auto moved = motions_.in_balance(parameters + step, o);
      const auto there = moved ? motions_.amplitude_of(mode, block.phase, *moved) : std::nullopt;
      third.of_open.push_back(there ? std::abs((*there - *without) * unit) : INFINITY);
    }
    return third;
  }

 private:
  // What ensembles of a dwell agree on, harmonics with it, at the phases of the first.
  Observation mean_of(std::span<const Observation> ensembles) const {
    Observation mean = mean_motion(ensembles, *set_.model, *set_.resonance);
    const Observation& first = ensembles.front();
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

  std::size_t largest_mode(const Observation& o) const {
    std::size_t found = 0;
    double most = -1;
    for (std::size_t k = 0; k < o.amplitude.size(); ++k)
      if (const double size = std::abs(o.amplitude[k] * derived(o.rate[k].imag(), derivatives_)); size > most) {
        most = size;
        found = k;
      }
    return found;
  }

  // Of the mode's third harmonic, where it is measured in responses and excitation.
  std::optional<std::size_t> block_of(const Observation& o, std::size_t mode) const {
    for (std::size_t b = 0; b < set_.resonance->blocks.size(); ++b) {
      const RegressorBlock& block = set_.resonance->blocks[b];
      if (block.kind == BlockKind::harmonic && static_cast<std::size_t>(block.mode) == mode &&
          o.harmonic_sd[b] >= 0 && o.forcing_harmonic_sd[b] >= 0 &&
          std::abs(block_frequency(block, o) / o.rate[mode].imag() - 3) < 1e-3)
        return b;
    }
    return std::nullopt;
  }

  Complex predicted(const VectorXd& parameters, const Observation& o, std::size_t block) const {
    return predicted_harmonics(*set_.model, *set_.resonance, parameters, o)[block];
  }

  const ObservationSet& set_;
  const Estimate& estimate_;
  int derivatives_;
  BalancedMotions motions_;
};

// How much of an excess counts: all of it where the estimate determines the prediction, none of it where a step
// along what it leaves open moves the prediction by more than noise.
double determined(const std::vector<ThirdHarmonic>& dwells) {
  double most = 0;
  for (std::size_t d = 0; d < dwells.front().of_open.size(); ++d) {
    double moved = 0;
    for (const ThirdHarmonic& e : dwells) moved += std::pow(e.of_open[d] / e.sd, 2) / 2;
    most = std::max(most, moved / static_cast<double>(dwells.size()));
  }
  return std::max(0.0, 1 - most);
}

// docs/inference.md (56): the share at the largest motion, zero where chance makes as much.
double third_of_sensor(const std::vector<ThirdHarmonic>& dwells) {
  const auto count = static_cast<Index>(dwells.size());
  if (count < 3) return 0;
  double largest = 0;
  for (const ThirdHarmonic& e : dwells) largest = std::max(largest, e.motion);
  const auto steps = static_cast<Index>(dwells.front().of_estimate.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count + steps, 1 + steps);
  VectorXd target = VectorXd::Zero(count + steps);
  for (Index i = 0; i < count; ++i) {
    const ThirdHarmonic& e = dwells[static_cast<std::size_t>(i)];
    target(i) = e.left / e.sd;
    matrix(i, 0) = std::pow(e.motion / largest, 2) / e.sd;
    for (Index d = 0; d < steps; ++d) matrix(i, 1 + d) = e.of_estimate[static_cast<std::size_t>(d)] / e.sd;
  }
  matrix.bottomRightCorner(steps, steps).setIdentity();
  return beyond_chance(matrix, target, 0, static_cast<double>(count - 1), determined(dwells));
}

}  // namespace

std::optional<CubicSensor> cubic_sensor(std::span<const ObservationSet> measured, const Estimate& estimate,
                                        int derivatives, unsigned threads) {
  std::optional<CubicSensor> result;
  for (const ObservationSet& set : measured) {
    const ThirdHarmonics harmonics(set, estimate, derivatives);
    if (!harmonics.known()) continue;
    const std::vector<RecordRange> records = ranges_of_records(set.observations);
    std::vector<std::optional<ThirdHarmonic>> all(records.size());
    in_parallel(all.size(), threads,
                [&](std::size_t i) { all[i] = harmonics.of(records[i].of(set.observations)); });
    std::vector<ThirdHarmonic> dwells;
    for (std::optional<ThirdHarmonic>& one : all)
      if (one && one->sd > 0) dwells.push_back(std::move(*one));
    const double third = third_of_sensor(dwells);
    if (third == 0 || (result && std::abs(third) <= std::abs(result->third))) continue;
    double largest = 0;
    for (const ThirdHarmonic& e : dwells) largest = std::max(largest, e.motion);
    result = CubicSensor{set.resonance, third / (largest * largest), third, derivatives};
  }
  return result;
}

ObservationSet without_cubic_part(const ObservationSet& set, const CubicSensor& sensor) {
  ObservationSet result = set;
  for (Observation& o : result.observations)
    for (std::size_t k = 0; k < o.amplitude.size(); ++k) {
      const double seen = std::abs(o.amplitude[k] * derived(o.rate[k].imag(), sensor.derivatives));
      o.amplitude[k] *= 1 - 3 * sensor.k * seen * seen;
    }
  return result;
}

}  // namespace secular
