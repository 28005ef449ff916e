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
};

/// Judged is how far a sample is off the cubic through two neighbours on either side, in units of the median of
/// that over 64 samples there or beside, so that what is smooth on the scale of five samples does not count. The
/// largest of these are outside of the tail of the others if a gap parts them. In a tail that falls exponentially
/// or faster the spacings of ordered values have known means (Renyi), which makes the gap over the others, of as
/// many values as the root of all, an F law with 2 and 2m degrees of freedom. Held samples and what follows them do
/// not count.
Impulses find_impulses(std::span<const double> samples, const ValueGrid& grid, const HeldSamples& held,
                       double false_alarm);

}  // namespace secular
