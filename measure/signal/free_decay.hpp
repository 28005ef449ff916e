#pragma once

#include <Eigen/Core>
#include <optional>

namespace secular {

/// Where a free swing begins in a record, and its frequency there.
struct DecayStart {
  Eigen::Index sample = 0;
  double frequency = 0;  ///< rad/s, of the fundamental
};

/// Finds the beginning of a free decay: whatever the structure did before release (held still, pulled, struck), the
/// largest excursion comes last before it swings freely. The decay is taken from the first crossing of the rest
/// position after the signal was last within 1 % of its largest excursion, moved on by half periods while a damped
/// sine with harmonics leaves clearly more there than later on (a hand that still touches). Where no
/// oscillation of at least two periods follows the largest excursion, but one leads up to it (a motion that
/// excites itself, onto its limit cycle), or the motion keeps its size to 1 % throughout a record of up to seven
/// turns, the record is free from its first sample on; nothing if there is none of these. samples: one channel;
/// rate in Hz.
std::optional<DecayStart> find_decay_start(const Eigen::Ref<const Eigen::VectorXd>& samples, double rate);

/// Dominant frequency (rad/s) near `expected` from a circular-hyperbolic decomposition of the samples, averaged
/// down to about 16 a period. Returns `expected` where the decomposition sees nothing within 20 % of it.
double decomposed_frequency(const Eigen::Ref<const Eigen::VectorXd>& samples, double rate, double expected);

}  // namespace secular
