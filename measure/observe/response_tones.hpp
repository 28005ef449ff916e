#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "measure/observe/mode_frequencies.hpp"
#include "measure/observe/observation_set.hpp"
#include "measure/observe/related_tones.hpp"

namespace secular {

/// A frequency as a function of those that a resonance leaves free, u: fixed + coupling*u, rad/s.
struct RelatedTone {
  Eigen::RowVectorXd coupling;
  double fixed = 0;

  double at(const Eigen::VectorXd& free) const { return fixed + (coupling.size() > 0 ? coupling.dot(free) : 0.0); }
};

/// Frequencies of an ensemble's tones, and how closely its samples tell tones apart.
struct ToneSetting {
  std::vector<double> excitation;  ///< rad/s
  Eigen::VectorXd free;            ///< u, nearly
  double resolution = 0, nyquist = 0;
};

/// All that is fitted to the responses of one ensemble: the modes' tones, the harmonics that the case regresses,
/// and what else is likely to be there and must not count as noise: combinations of up to three of the modes' and
/// excitations' frequencies. A tone that samples or window do not show has index -1.
class ResponseTones {
 public:
  ResponseTones(const CompiledModel& model, const CompiledCase& resonance, const ModeFrequencies& modes,
                const ToneSetting& setting, const Window& window);

  const std::vector<RelatedTone>& tones() const { return tones_; }
  /// The first so many are the modes' own.
  std::size_t main() const { return main_; }
  const RelatedTone& of_mode(std::size_t mode) const { return of_mode_[mode]; }
  /// In tones().
  std::ptrdiff_t mode_index(std::size_t mode) const { return mode_index_[mode]; }
  std::ptrdiff_t block_index(std::size_t block) const { return block_index_[block]; }
  /// Whether a block's frequency is negative: its tone is the conjugate then.
  bool reversed(std::size_t block) const { return reversed_[block]; }

  /// The first `count` tones.
  RelatedTones related(std::size_t count) const;

 private:
  RelatedTone sum_of(const std::vector<int>& multiples) const;
  std::ptrdiff_t take(const RelatedTone& tone, double apart);
  void take_modes(const ModeFrequencies& modes);
  void take_blocks(const CompiledCase& resonance);
  void take_combinations(const ModeFrequencies& modes);

  ToneSetting setting_;
  const Window& window_;
  std::vector<RelatedTone> tones_, of_mode_;
  std::size_t main_ = 0;
  std::vector<std::ptrdiff_t> mode_index_, block_index_;
  std::vector<bool> reversed_;
};

}  // namespace secular
