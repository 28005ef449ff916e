#pragma once

namespace secular {

/// What a channel shows on the mean that reads `value` with Gaussian noise of `noise_sd` and is cut at +-level
/// after the noise came in: E clamp(value + noise, -level, level). Noise carries readings over the level before the
/// signal reaches it and keeps some of them under it afterwards, so that the corner of the cut is round.
double saturated(double value, double level, double noise_sd);

/// Half-amplitude of the fundamental that a saturated channel shows of a sinusoid of half-amplitude `half`
/// (describing function of the above, all in the channel's unit), and the half-amplitude that makes it show
/// `shown`. The first tends to that of a square wave, 2/pi level; what shows more than can be undone gives 50
/// level.
double saturated_fundamental(double half, double level, double noise_sd);
double unsaturated_amplitude(double shown, double level, double noise_sd);

}  // namespace secular
