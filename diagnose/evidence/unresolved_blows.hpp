#pragma once

#include <vector>

#include "diagnose/evidence/segment.hpp"

namespace secular {

/// Samples of a segment between which a blow acts, in order, with one on either side: the interpolation of what
/// drives is off there by what a corner of the blow does. None where no excitation holds a blow.
std::vector<Eigen::Index> samples_of_blow(const Segment& segment);

/// Relative standard deviation of what blows do at this frequency (rad/s), next to what their samples say: what is
/// between the samples is not known (docs/inference.md (42)). `segments`: of impacts; those without a blow say
/// nothing, and 0 is the answer of all that do not. Root mean square over blows and excitations, 1 at most.
double unresolved_share(const std::vector<const Segment*>& segments, double frequency);

}  // namespace secular
