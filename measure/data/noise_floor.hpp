#pragma once

#include <optional>
#include <span>

namespace secular {

/// Rms of the white noise that would explain the quietest part of the upper half of the spectrum (a quarter to a
/// half of the sample rate), from the median of Hann-windowed periodograms: neither a line nor a knock in some
/// segments raises it. The mean of all eighths of that half that are, within chance, as quiet as the quietest:
/// which by itself would be too quiet, as the least of eight. The signal must leave some of that band free, or this
/// is an upper bound; a converter's anti-aliasing filter lowers it; leakage of a line leaves a floor 120 dB below
/// the line. Nothing for fewer than 1024 samples. All samples must be finite.
std::optional<double> noise_floor(std::span<const double> samples);

/// The same where a signal may fill the upper half: the least level that three neighbouring eighths of it share
/// within what chance leaves in 99 of 100 records. A signal's edge slopes more than that; one that is flat there and
/// not below counts as noise. Nothing where no three agree, and where the noise would be more than half of the
/// samples' variance: white excitation is flat, too.
std::optional<double> flat_noise_floor(std::span<const double> samples);

}  // namespace secular
