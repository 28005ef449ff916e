#pragma once

#include <string>
#include <vector>

#include "measure/data/time_axis.hpp"

namespace secular {

/// Hz: the highest line that stands out of the mean spectrum of a channel (256 samples a segment) with a false
/// alarm in a million; half the sample rate where records are too short to tell, or show no line. All samples must
/// be finite.
double highest_tone_hz(const std::vector<std::vector<double>>& channels, double sample_rate_hz);

/// What it means that stamps scatter about the even axis that samples are read on, with the sizes for the highest
/// tone. A tone of angular frequency w sampled at times that are off by s (rms) is w*s of its amplitude away from
/// the even samples, which is white noise, and keeps 1 - (w*s)^2/2 of its amplitude.
std::string jitter_text(const TimeAxis& axis, const std::vector<std::vector<double>>& channels);

}  // namespace secular
