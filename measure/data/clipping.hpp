#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "measure/data/resolution.hpp"

namespace secular {

/// Samples stuck at the end of a sensor's or converter's range.
struct Clipping {
  std::size_t runs_high = 0, runs_low = 0;  ///< separate runs at the largest and at the smallest value
  std::size_t samples = 0;                  ///< in all of them
  /// Rising: every sample at an end of the range where there are such runs.
  std::vector<std::size_t> at{};
  bool found() const { return runs_high + runs_low > 0; }
};

/// Looks for samples stuck at the largest or smallest value.
///
/// Runs of four and more are judged one by one: their neighbours would have gone on. A
/// smooth peak of a quantised signal is flat too, and so is a structure held at rest, but both leave their extreme
/// with zero slope: the parabola through the samples beside either end of the run, depth(m) = slope*m +
/// curvature*m^2 from the first one outside, has its top slope^2/(4*curvature) above that sample, for such a
/// turning point at most about one quantum beyond the flat value, for a clipped one much more. Both ends of a run
/// must say so.
///
/// Shorter runs are judged together. With x in samples from its top and c its depth at x = 1, a smooth peak lies
/// within q of its top for |x| <= (q/c)^(1/2) if it is round and for |x| <= (q/c)^(1/4) if harmonics make it flat
/// to the third order; flatter ones need two coincidences. q is the greatest common divisor of all differences
/// between values near the extreme, at least a billionth of the range: the channel's quantum or more. The nearest
/// sample lies anywhere within half a sample of the top, so that the largest sample of a peak falls into one given
/// interval q with a probability of at most p = 2*(q/c)^(1/4), whatever the heights of the peaks are. Of `m` peaks
/// whose largest sample lies within c/4 of the channel's extreme, as deep as a sample of a peak that reaches it can
/// lie, `n` lie at the very extreme, one of them always: more than that with the binomial probability P(at least n
/// - 1 of m - 1). Clipped: that is below `measure_thresholds().clipping_false_alarm`. Where sampling is in step
/// with the motion, peaks are no independent draws: they repeat one. Their tops then lie at one offset x from the
/// sample, to (q/c)^(1/4) and the q/(2*c) by which quantised neighbours misplace it. Peaks that do not differ by
/// more differ by the noise alone; with its standard deviation s (noise_floor) p = q/(s*(2*pi)^(1/2)), of the peaks
/// within 6*s. A harmonic of fewer than four samples a period misleads these parabolas.
///
/// Not judged: an extreme that every step to is more than twice the largest of all other steps (a number that
/// stands for lost samples), signals of fewer than 64 quanta, signals of two levels (square waves), a level that
/// the signal rests at most of the time (between knocks), and runs that touch an end of the record. All samples
/// must be finite. `sorted`: the same in rising order; `grid`: theirs (grid_of_sorted).
Clipping find_clipping(std::span<const double> samples, const std::vector<double>& sorted, const ValueGrid& grid);

}  // namespace secular
