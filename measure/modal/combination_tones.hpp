#pragma once

#include <complex>
#include <cstddef>
#include <string>
#include <vector>

#include "numerics/confidence.hpp"

namespace secular {

/// A motion that free decays show, and how its pole moves with amplitude.
struct DecayingMotion {
  std::complex<double> pole;       ///< rad/s, over the records
  double growth_sd = 0;            ///< of the real part, 1/s
  double omega_sd = 0;             ///< of the imaginary part, rad/s
  Interval rate, omega;            ///< of -real part, 1/s, and imaginary part, rad/s, from small to large amplitude
  bool followed = false;           ///< whether these ranges are known; where not, it makes no combination
  double displacement = 0;         ///< first amplitude, of any common unit
  std::vector<double> amplitudes;  ///< by record of one kind of excitation, in any unit; empty: not known
};

/// times[0] of motions[0] and times[1] of motions[1]; the second of a harmonic is zero times.
struct Combination {
  std::size_t motions[2] = {0, 0};
  int times[2] = {0, 0};  ///< the second may be negative: a difference
  int order() const;      ///< sum of the moduli of both
};

enum class CombinationVerdict {
  tone,           ///< frequency and rate are those of the combination
  own_rate,       ///< the frequency is, the rate is not
  rates_unknown,  ///< the frequency is; the rates are not known well enough to tell
  by_chance,      ///< the frequency is; a mode would be found there by chance too often
  own_amplitude   ///< the frequency is; from record to record the amplitude goes with the excitation
};

/// A motion at the frequency of a combination of stronger ones.
struct CombinationMatch {
  std::size_t motion = 0;
  Combination combination;
  Interval omega, rate;  ///< of the combination, rad/s and 1/s
  double chance = 0;     ///< that a mode is within these and all combinations listed before
  CombinationVerdict verdict = CombinationVerdict::tone;
};

/// Of all motions the first match of each, docs/inference.md, Eqs. (C1) to (C5): combinations of two stronger
/// motions that are no tones themselves, listed by size until a mode would lie on one of them by chance with a
/// probability of `false_alarm`. Strongest motion first.
std::vector<CombinationMatch> find_combinations(const std::vector<DecayingMotion>& motions, double false_alarm);

}  // namespace secular
