#include "measure/observe/response_tones.hpp"

#include <cmath>
#include <cstdlib>

#include "estimator/model/zero_frequency.hpp"
#include "measure/signal/tone_separation.hpp"

namespace secular {
namespace {

using Eigen::Index;

/// Of frequencies that add up to a combination, each counted as often as it occurs.
constexpr int combination_order = 3;

// All rows of integers whose sizes add up to no more than `order`, zero where `there` says so.
std::vector<std::vector<int>> multiples_up_to(int order, const std::vector<bool>& there) {
  std::vector<std::vector<int>> all;
  std::vector<int> row(there.size(), 0);
  const auto choose = [&](const auto& self, std::size_t from, int left) -> void {
    if (from == there.size()) {
      all.push_back(row);
      return;
    }
    for (int n = there[from] ? -left : 0; n <= (there[from] ? left : 0); ++n) {
      row[from] = n;
      self(self, from + 1, left - std::abs(n));
    }
    row[from] = 0;
  };
  choose(choose, 0, order);
  return all;
}

}  // namespace

ResponseTones::ResponseTones(const CompiledModel& model, const CompiledCase& resonance,
                             const ModeFrequencies& modes, const ToneSetting& setting, const Window& window)
    : setting_(setting),
      window_(window),
      of_mode_(model.modes(), RelatedTone{Eigen::RowVectorXd::Zero(static_cast<Index>(modes.free.size())), 0}),
      mode_index_(model.modes(), -1),
      block_index_(resonance.blocks.size(), -1) {
  take_modes(modes);
  take_blocks(resonance);
  take_combinations(modes);
}

RelatedTones ResponseTones::related(std::size_t count) const {
  const Index unknowns = setting_.free.size();
  RelatedTones list{Eigen::VectorXd(static_cast<Index>(count)),
                    Eigen::MatrixXd(static_cast<Index>(count), unknowns), 0};
  for (std::size_t i = 0; i < count; ++i) {
    list.fixed(static_cast<Index>(i)) = tones_[i].fixed;
    if (unknowns > 0) list.coupling.row(static_cast<Index>(i)) = tones_[i].coupling;
  }
  return list;
}

// By multiples of the modes' frequencies, then the excitations'.
RelatedTone ResponseTones::sum_of(const std::vector<int>& multiples) const {
  RelatedTone tone{Eigen::RowVectorXd::Zero(setting_.free.size()), 0};
  for (std::size_t i = 0; i < multiples.size(); ++i) {
    if (i < of_mode_.size()) {
      tone.coupling += multiples[i] * of_mode_[i].coupling;
      tone.fixed += multiples[i] * of_mode_[i].fixed;
    } else {
      tone.fixed += multiples[i] * setting_.excitation[i - of_mode_.size()];
    }
  }
  return tone;
}

// Its index: that of a tone within half a bin, or its own, where it is `apart` bins from every other.
std::ptrdiff_t ResponseTones::take(const RelatedTone& tone, double apart) {
  const double f = tone.at(setting_.free), resolution = setting_.resolution;
  if (f < bins_between_tones * resolution || f > setting_.nyquist - bins_between_tones * resolution ||
      !window_.passes(f))
    return -1;
  for (std::size_t i = 0; i < tones_.size(); ++i)
    if (std::abs(tones_[i].at(setting_.free) - f) < half_a_bin * resolution) return static_cast<std::ptrdiff_t>(i);
  for (const RelatedTone& other : tones_)
    if (std::abs(other.at(setting_.free) - f) < apart * resolution) return -1;
  tones_.push_back(tone);
  return static_cast<std::ptrdiff_t>(tones_.size() - 1);
}

void ResponseTones::take_modes(const ModeFrequencies& modes) {
  for (std::size_t k = 0; k < of_mode_.size(); ++k) {
    if (!modes.oscillates[k]) continue;
    of_mode_[k].coupling = modes.coupling.row(static_cast<Index>(k));
    for (std::size_t j = 0; j < setting_.excitation.size(); ++j)
      of_mode_[k].fixed += modes.forced(static_cast<Index>(k), static_cast<Index>(j)) * setting_.excitation[j];
    mode_index_[k] = take(of_mode_[k], 0);
  }
  main_ = tones_.size();
}

// Harmonics of first order are regressed; weaker ones are fitted where they cost the others nothing.
void ResponseTones::take_blocks(const CompiledCase& resonance) {
  std::vector<RelatedTone> tone;
  for (const RegressorBlock& block : resonance.blocks) {
    tone.push_back(sum_of({block.phase.begin(), block.phase.end()}));
    reversed_.push_back(tone.back().at(setting_.free) < 0);
    if (reversed_.back()) tone.back() = {-tone.back().coupling, -tone.back().fixed};
  }
  for (const int order : {1, 2})
    for (std::size_t b = 0; b < resonance.blocks.size(); ++b) {
      const RegressorBlock& block = resonance.blocks[b];
      if (block.kind == BlockKind::harmonic && !is_zero_frequency(block) && (block.order <= 1) == (order == 1))
        block_index_[b] = take(tone[b], order == 1 ? 0 : bins_between_tones);
    }
}

void ResponseTones::take_combinations(const ModeFrequencies& modes) {
  std::vector<bool> there = modes.oscillates;
  there.resize(of_mode_.size() + setting_.excitation.size(), true);
  for (const std::vector<int>& multiples : multiples_up_to(combination_order, there))
    take(sum_of(multiples), bins_between_tones);
}

}  // namespace secular
