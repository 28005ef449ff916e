#pragma once

#include <cstddef>
#include <span>

namespace secular {

/// Samples stuck at the end of a sensor's or converter's range.
struct Clipping {
  std::size_t runs_high = 0, runs_low = 0;  ///< separate runs at the largest and at the smallest value
  std::size_t samples = 0;                  ///< in all of them
  bool found() const { return runs_high + runs_low > 0; }
};

/// Looks for runs of at least four samples at the largest or smallest value whose neighbours would have gone on. A
/// smooth peak of a quantised signal is flat too, and so is a structure held at rest, but both leave their extreme
/// with zero slope: the parabola through the samples beside either end of the run, depth(m) = slope*m +
/// curvature*m^2 from the first one outside, has its top slope^2/(4*curvature) above that sample, for such a
/// turning point at most about one quantum beyond the flat value, for a clipped one much more. Both ends of a run
/// must say so. Not judged: signals of fewer than 64 quanta, signals of two levels (square waves), a level that the
/// signal rests at most of the time (between knocks), and runs that touch an end of the record. All samples must be
/// finite.
Clipping find_clipping(std::span<const double> samples);

}  // namespace secular
