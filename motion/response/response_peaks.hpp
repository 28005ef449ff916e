#pragma once

#include "motion/response/response_curve.hpp"

namespace secular {

/// Puts the largest amplitudes of every mode that lie inside of a branch among its points, each where the amplitude
/// is level along the branch to rounding, and marks them (ResponsePoint::peaks). Found are those between points
/// where it rises at one and falls at the other, by more than rounding. `diagram` is what response_diagram() made
/// of the same request.
void add_peaks(const ResponseField& field, const ResponseRequest& request, ResponseDiagram& diagram);

}  // namespace secular
