#pragma once

#include <optional>
#include <span>

namespace secular {

/// Noise beside white noise whose correlation falls exponentially: the simplest colour, of a first-order filter.
struct NoiseColour {
  double sd = 0, time_s = 0;  ///< time in which the correlation falls to 1/e
  double white_sd = 0;        ///< of the white noise
};

/// That (docs/inference.md (37)) in what a model leaves of a record, `left`, by the likeliest spectrum (P. Whittle,
/// Arkiv for Matematik 2, 1953) of the bins between multiples of the motion's own line, where no missing term of
/// the equations acts: none where white noise alone is as likely, by chi-squared with two degrees of freedom for
/// every octave of correlation times. `motion`: as many samples.
std::optional<NoiseColour> find_noise_colour(std::span<const double> left, std::span<const double> motion,
                                             double rate_hz, double false_alarm);

/// Whether that is louder, or less loud, where the motion is than elsewhere (F law of the variances of both halves
/// of the record's blocks): noise of a sensor does not know of the motion, what a missing term leaves does.
bool follows(const NoiseColour& colour, std::span<const double> left, std::span<const double> motion,
             double rate_hz, double false_alarm);

}  // namespace secular
