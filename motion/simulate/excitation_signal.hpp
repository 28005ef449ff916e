#pragma once

#include <cstdint>
#include <vector>

#include "motion/simulate/motion.hpp"

namespace secular {

/// Base motions of a virtual test, for one excitation of a model; all with their first two derivatives by time.

/// amplitude*(cos(x) + sum_n harmonics[n]*cos((n+2)*x)) with x = omega*t + phase; a shaker that distorts has
/// harmonics.
ExcitationSignal harmonic_wave(double omega, double amplitude, double phase, std::vector<double> harmonics = {});

/// The same with a frequency that moves linearly in time, from `from_hz` at time 0 by `rate_hz_per_s`.
ExcitationSignal linear_sweep(double from_hz, double rate_hz_per_s, double amplitude,
                              std::vector<double> harmonics = {});

/// A half-sine pulse from `at_s` on: peak*sin(pi*(t - at_s)/width_s).
ExcitationSignal half_sine_pulse(double peak, double at_s, double width_s);

/// Random-phase multisine: `lines` cosines of equal amplitude at equally spaced frequencies from low_hz to high_hz,
/// phases from `seed`, root mean square `rms`.
ExcitationSignal random_phase_multisine(double low_hz, double high_hz, std::size_t lines, double rms,
                                        std::uint64_t seed);

/// One signal for each excitation of a model, in their order.
ExcitationSignal side_by_side(std::vector<ExcitationSignal> signals);

}  // namespace secular
