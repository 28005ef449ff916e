#pragma once

namespace secular {

/// Bins (1 over the length of a window) from a tone to another of which a window's samples tell it apart, their
/// amplitudes being polynomials of these degrees in time; a constant is a tone at frequency zero: docs/inference.md
/// (47).
constexpr double bins_between(int degree, int other_degree) {
  return 0.5 * (degree + 1) + 0.5 * (other_degree + 1);
}

/// The same of tones of constant amplitude whose frequencies are not known beforehand: to first order one that is
/// off by a little is a slope of the amplitude.
inline constexpr double bins_between_tones = bins_between(1, 1);

/// A tone is nearest to its own line of a Fourier transform that far, in bins.
inline constexpr double half_a_bin = 0.5;

}  // namespace secular
