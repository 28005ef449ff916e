#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "measure/data/resolution.hpp"
#include "measure/disturbances/held_samples.hpp"

namespace secular {

/// Samples that stand out of what surrounds them.
struct Impulses {
  struct One {
    std::size_t at = 0;
    double size = 0;  ///< off the neighbours
  };
  std::vector<One> spikes;  ///< of one sample alone
  std::vector<One> knocks;  ///< that neighbours stand out with
  std::vector<double> scales;
  double many = 0;  ///< next to its scale no sample is off its neighbours by more, but those of another kind

  /// What a sample is off its neighbours by at most, in the channel's unit.
  double most_off(std::size_t sample) const { return many * scales[sample]; }
};

/// Judged is how far a sample is off the cubic through two neighbours on either side, in units of the median of
/// that over 64 samples there or beside, so that what is smooth on the scale of five samples does not count. The
/// largest of these are outside of the tail of the others if a gap parts them: in a tail that falls exponentially
/// or faster the spacings of ordered values have known means (Renyi), which makes the gap over the others, of as
/// many values as the root of all, an F law with 2 and 2m degrees of freedom. One is a spike if putting it right
/// puts its neighbours right; else a knock. Where many hide one another there is no gap: then a spike is beyond the
/// tail that most of the others have, from their middle and their upper quarter, no more is left beside it than
/// beside others (beside_spike), and less than a corner of the motion of that size would leave. Either way a spike
/// explains what is around it better than a corner does (beside_corner). Spikes are put right, and the search
/// begins anew, until none is found. Held samples and what has them among its neighbours do not count.
Impulses find_impulses(std::span<const double> samples, const ValueGrid& grid, const HeldSamples& held,
                       double false_alarm);

}  // namespace secular
