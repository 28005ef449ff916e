#pragma once

#include <Eigen/Core>
#include <vector>

#include "diagnose/evidence/discrepancy.hpp"
#include "diagnose/evidence/segment.hpp"

namespace secular {

/// Segments of free decays cut down to one turn of the lowest mode; what drives others is not known to act yet.
/// `natural_frequency`: rough, by mode, rad/s.
std::vector<Segment> first_turns(std::vector<Segment> segments, const std::vector<double>& natural_frequency);

/// Natural frequencies by such first turns, from a start that is right to less than a half, all other unknowns as
/// they are (docs/inference.md (40)). `which`: those that are looked for. One stays where it is near enough for six
/// turns, and where the turns do not tell one as sharply as that, between a half of it and twice it.
Eigen::VectorXd first_frequencies(Discrepancy& turns, const Eigen::VectorXd& start,
                                  const std::vector<std::size_t>& which, unsigned threads);

}  // namespace secular
