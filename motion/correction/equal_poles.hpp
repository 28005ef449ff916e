#pragma once

#include <complex>
#include <span>
#include <vector>

#include "measure/observe/observation_set.hpp"

namespace secular {

/// A filter of equal real poles: a low-pass, (1 + i w tau)^-n, or a high-pass, (i w tau/(1 + i w tau))^n.
struct EqualPoles {
  /// By how much a low-pass makes a line at `frequency` late, a high-pass early. Negative: the excitation passes
  /// the filter, not the responses.
  double late_s = 0;
  double frequency = 0;  ///< rad/s, the mean one of what is late
  int poles = 1;         ///< that together are as late
  bool high_pass = false;

  double time_constant() const;  ///< s, of each
  double amplitude() const;      ///< what they leave of an amplitude at the frequency
  /// What a line at a frequency (rad/s) has to be multiplied with, as an amplitude of exp(i w t): the poles taken
  /// out, and the delay as which they were taken out before put back.
  std::complex<double> inverse(double at_frequency) const;
  /// By how much the logarithm of `inverse` changes with the frequency, s.
  std::complex<double> slope_of_inverse(double at_frequency) const;
};

/// The observations before the filter, docs/inference.md (61), (72), sets whose phases are unknown and
/// decays: responses, or excitations where these pass it. Other sets are as they were.
std::vector<ObservationSet> before_poles(std::span<const ObservationSet> measured, const EqualPoles& filter);

}  // namespace secular
