#pragma once

#include <optional>
#include <span>

namespace secular {

/// Rms of the white noise that would explain the quietest part of the upper half of the spectrum (a quarter to a
/// half of the sample rate), from the median of Hann-windowed periodograms: neither a line nor a knock in some
/// segments raises it. The signal must leave some of that band free, or this is an upper bound; a converter's
/// anti-aliasing filter lowers it; leakage of a line leaves a floor 120 dB below the line. Nothing for fewer than
/// 1024 samples. All samples must be finite.
std::optional<double> noise_floor(std::span<const double> samples);

}  // namespace secular
