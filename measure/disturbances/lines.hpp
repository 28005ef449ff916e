#pragma once

#include <span>
#include <vector>

namespace secular {

/// A line that stands out of the spectrum around it.
struct Line {
  double frequency_hz = 0;
  double amplitude = 0;                    ///< peak
  bool steady = false;                     ///< as large in all of the record, as far as noise lets see
  double first_half = 0, second_half = 0;  ///< how large there, in one unit
  double half_sd = 0;                      ///< what noise makes of these
};

/// Bins of the transform on either side of a line that its main lobe takes under the window that lines are found
/// with: two lines that are nearer cannot be told apart.
inline constexpr double lobe_bins = 4;

/// Nearer to either end of the spectrum, in bins, no line is looked for: noise beside it is needed.
inline constexpr std::ptrdiff_t line_reach = 19;

/// The window of Blackman and Harris with four terms, whose side lobes are 92 dB down.
std::vector<double> lobe_window(std::size_t length);

/// Powers of the transform of samples (about their mean) under that window, up to Nyquist; the length is even.
std::vector<double> windowed_powers(std::span<const double> samples, const std::vector<double>& window);

/// Peaks of the windowed periodogram. In noise of any colour that is smooth over 40 bins the peak's bin over the
/// mean of 8 bins that share no noise with it has an F law with 2 and 16 degrees of freedom; the noisier of both
/// sides is taken. `false_alarm` is that of the whole spectrum: every bin is a test. A decaying or modulated line
/// has skirts and stands out less; `steady` asks further whether either half shows it (one test at `false_alarm`),
/// amplitudes of the halves differ by no more than the noise around them in each, and the whole record, whose
/// window is highest where theirs are low, shows no more than both (a resonance that is driven in passing does).
///
/// `spectrum`, if asked for: the powers of all bins.
std::vector<Line> find_lines(std::span<const double> samples, double rate, double false_alarm,
                             std::vector<double>* spectrum = nullptr);

/// Root mean square of the second half over that of the first, each about its mean.
double change_between_halves(std::span<const double> motion);

/// What terms of an equation make at multiples of a motion's frequency are powers of the motion: they fall, or
/// grow, from one half of a record to the other at least as its square. Whether a steady line cannot, beside a
/// motion that changes by so much, whatever its frequency.
bool outlasts_products(const Line& line, double change, double false_alarm);

/// Probability that the noise around a bin alone gives as much as the strongest of it and its two neighbours; one
/// near the ends of the spectrum.
double probability_of_no_line(const std::vector<double>& powers, std::size_t bin);

}  // namespace secular
