#pragma once

#include <complex>
#include <span>
#include <string_view>
#include <vector>

namespace secular {

/// Measured tones of one ensemble. One-sided Fourier coefficients as the thesis uses them: their moduli are peak
/// amplitudes. Frequencies in rad/s; one mode: only the first.
struct EnsembleTones {
  double excitation_frequency = 0;
  std::complex<double> excitation;
  double mode_frequency[2] = {0, 0};
  std::complex<double> mode[2];
};

/// One of the thesis's regressions of the harmonics that a first-order expansion adds to the response.
struct ThesisHarmonic {
  std::string_view equation;                   ///< "6.43"
  std::span<const std::string_view> unknowns;  ///< what its coefficients are
  std::size_t modes = 1;                       ///< of the model it belongs to
  std::size_t mode = 0;                        ///< whose response holds the harmonic
  int phase[2] = {0, 0};                       ///< its frequency over the modes' frequencies
  std::string_view misprint;                   ///< what is wrong with it as printed; empty: nothing
  /// Columns by unknown. `printed`: as the thesis prints them; otherwise with the misprint put right.
  void (*columns)(const EnsembleTones& tones, bool printed, std::complex<double>* columns) = nullptr;

  double frequency(const EnsembleTones& tones) const {
    return phase[0] * tones.mode_frequency[0] + phase[1] * tones.mode_frequency[1];
  }
};

/// Eqs. (5.38) and (6.43)-(6.48).
std::span<const ThesisHarmonic> thesis_harmonics();

}  // namespace secular
