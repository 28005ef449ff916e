#include "motion/correction/noise_left.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "input/input_error.hpp"
#include "measure/observe/modal_projection.hpp"
#include "measure/observe/observed_blocks.hpp"

namespace secular {
namespace {

/// Where the search for the noise begins, by the largest amplitude of a mode. Where it ends hangs on it no more
/// than the tolerance says.
constexpr double first_share = 1e-3;

/// Numbers hang on the noise by errors in columns alone, by shares of its square.
constexpr double same_noise = 0.03;
constexpr int most_noise_rounds = 6;

/// Of the largest amplitude, below which what is left is rounding.
constexpr double rounding_of_tables = 1e-12;

std::size_t unknown_rows(const ObservationSet& set) {
  return static_cast<std::size_t>(std::count_if(set.observations.begin(), set.observations.end(),
                                                [](const Observation& o) { return !o.noise_known; }));
}

/// Levels of noise, of half of the peak of what the channels measure: of each mode's own line and of each block's.
class UnstatedLevels {
 public:
  UnstatedLevels(ObservationSet& set, int derivatives)
      : set_(set),
        derivatives_(derivatives),
        of_mode_(set.model->modes(), 0.0),
        of_block_(set.resonance->blocks.size(), 0.0) {
    for (const Observation& o : set.observations)
      for (std::size_t k = 0; !o.noise_known && k < of_mode_.size(); ++k)
        of_mode_[k] = std::max(of_mode_[k], first_share * std::abs(o.amplitude[k]) * slope(o.rate[k].imag()));
    for (std::size_t b = 0; b < of_block_.size(); ++b)
      of_block_[b] = of_mode_[static_cast<std::size_t>(set.resonance->blocks[b].mode)];
    for (const double level : of_mode_) least_.push_back(level / first_share * rounding_of_tables);
    put();
  }

  // By what an estimate leaves; the largest relative change.
  double take(const Estimate& estimate) {
    std::set<std::string> columns;
    double rows = 0;
    const std::string name(set_.resonance->name);
    for (const BlockQuality& quality : estimate.blocks) {
      if (quality.resonance != name) continue;
      for (const auto& [column, inflation] : quality.variance_inflation) columns.insert(column);
      rows += static_cast<double>(quality.equations);
    }
    freedom_ = rows - static_cast<double>(columns.size());
    if (!(freedom_ >= 1))
      throw InputError(std::string(set_.model->name), "case " + name,
                       fmt::format("{} rows of tables do not say their standard deviations, and leave no degree of "
                                   "freedom to tell them",
                                   unknown_rows(set_)),
                       "columns CHANNEL.sd, or more rows");
    const double fitted = std::sqrt(rows / freedom_);
    double change = 0;
    for (const BlockQuality& quality : estimate.blocks)
      for (std::size_t b = 0; b < of_block_.size(); ++b) {
        const RegressorBlock& block = set_.resonance->blocks[b];
        if (quality.resonance != name || block.name != quality.name) continue;
        const auto mode = static_cast<std::size_t>(block.mode);
        double& level = block.kind == BlockKind::modulation ? of_mode_[mode] : of_block_[b];
        const double ratio = fitted * quality.normalised_residual;
        if (!std::isfinite(ratio) || !(level > 0)) continue;
        const double before = level;
        level = std::max(ratio * level, least_[mode]);
        change = std::max(change, std::abs(level / before - 1));
      }
    put();
    return change;
  }

  void note(Estimate& estimate) const {
    for (std::size_t k = 0; k < of_mode_.size(); ++k) {
      if (!(of_mode_[k] > 0)) continue;
      const UnstatedNoise noise{std::string(set_.resonance->name), std::string(set_.model->coordinates[k]),
                                2 * of_mode_[k], freedom_, unknown_rows(set_)};
      estimate.warnings.push_back(fmt::format(
          "case {}: {} rows of tables do not say their standard deviations: a line of {} is taken to scatter by "
          "{:.3g} in its real and its imaginary part, {:.2g} % of the largest, as the model leaves them ({:.0f} "
          "degrees of freedom). Whether the equations hold cannot be judged by that, and errors of the level are "
          "taken as none",
          noise.resonance, noise.rows, noise.mode, noise.sd,
          100 * of_mode_[k] * rounding_of_tables / std::max(least_[k], 1e-300), noise.degrees_of_freedom));
      estimate.unstated_noise.push_back(noise);
    }
  }

 private:
  double slope(double frequency) const { return std::pow(std::abs(frequency), derivatives_); }

  void put() {
    for (Observation& o : set_.observations) {
      if (o.noise_known) continue;
      for (std::size_t k = 0; k < of_mode_.size(); ++k)
        o.amplitude_sd[k] = o.amplitude[k] == std::complex<double>() ? 0 : of_mode_[k] / slope(o.rate[k].imag());
      for (std::size_t b = 0; b < o.harmonic.size(); ++b)
        if (o.harmonic_sd[b] >= 0) {
          const double f = frequency_of(b, o);
          o.harmonic_sd[b] = f > 0 ? of_block_[b] / slope(f) : of_block_[b];
        }
    }
  }

  double frequency_of(std::size_t b, const Observation& o) const {
    return std::abs(block_frequency(set_.resonance->blocks[b], o));
  }

  ObservationSet& set_;
  int derivatives_;
  std::vector<double> of_mode_, of_block_, least_;
  double freedom_ = 0;
};

// What a model leaves of rows whose noise is known and of others together is the noise of neither.
void leave_out_beside_known(ObservationSet& set, std::vector<std::string>& warnings) {
  const std::size_t unknown = unknown_rows(set);
  if (unknown == 0 || unknown == set.observations.size()) return;
  std::erase_if(set.observations, [](const Observation& o) { return !o.noise_known; });
  warnings.push_back(fmt::format(
      "case {}: {} rows of tables do not say their standard deviations, left out beside {} "
      "observations whose noise is known; add columns CHANNEL.sd, or leave the others out with --records",
      set.resonance->name, unknown, set.observations.size()));
}

}  // namespace

CorrectedEstimate estimate_with_noise_left(std::vector<ObservationSet>& sets, const EstimateTask& task) {
  std::vector<UnstatedLevels> levels;
  std::vector<std::string> warnings;
  for (ObservationSet& set : sets) {
    leave_out_beside_known(set, warnings);
    if (unknown_rows(set) > 0) levels.emplace_back(set, modal_projection(task.campaign, *set.model).derivatives);
  }
  CorrectedEstimate result = estimate_corrected(sets, task);
  double change = 0;
  for (int round = 0; round < most_noise_rounds && !levels.empty(); ++round) {
    change = 0;
    for (UnstatedLevels& of_set : levels) change = std::max(change, of_set.take(result.estimate));
    if (round > 0 && change < same_noise) break;
    result = estimate_corrected(sets, task);
  }
  if (!(change < same_noise))
    warnings.push_back(fmt::format(
        "noise of rows that do not say it is not settled: it still moves by {:.0f} % a round", 100 * change));
  result.estimate.warnings.insert(result.estimate.warnings.end(), warnings.begin(), warnings.end());
  for (const UnstatedLevels& of_set : levels) of_set.note(result.estimate);
  return result;
}

}  // namespace secular
