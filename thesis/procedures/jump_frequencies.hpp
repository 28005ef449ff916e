#pragma once

#include <optional>
#include <span>

namespace secular {

/// One dwell of a stepped sweep, in the order it was run.
struct SweepDwell {
  double frequency = 0;  ///< of the excitation, rad/s
  bool responds = false;
};

/// Where a sweep first finds a response: between the last quiet dwell and the first that responds.
struct Onset {
  double quiet = 0, responds = 0;  ///< rad/s
};

/// Nothing if the sweep never responds or responds from its first dwell.
std::optional<Onset> onset_of(std::span<const SweepDwell> sweep);

/// Excitation frequency at exact resonance (2 w0, w1 + w2) from the onsets of a forward and a reverse sweep: the
/// interval in which rest is unstable is symmetric about it, thesis Eq. (5.27) and section 6.4.
struct ResonanceCentre {
  double thesis = 0;     ///< mean of the first frequencies that responded, as the thesis takes it
  double bracketed = 0;  ///< mean of the middles of both brackets
  double sd = 0;         ///< of `bracketed`, from the widths of the brackets
};
ResonanceCentre resonance_centre(const Onset& forward, const Onset& reverse);

}  // namespace secular
