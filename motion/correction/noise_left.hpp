#pragma once

#include <vector>

#include "motion/correction/corrected_estimate.hpp"

namespace secular {

/// estimate_corrected() of sets in which rows of tables may not say their noise (Observation::noise_known): one
/// standard deviation of a line for all such rows of a case, in the units of the channels, is then what the model
/// leaves of them, by its degrees of freedom, found in turn with the estimate: of each mode's own line, and of each
/// harmonic. `sets` get it. That noise tells nothing of whether equations hold: no such test is made of these
/// cases. Such rows beside others whose noise is known are left out, with a warning. Throws InputError
/// where there are no more of them than unknowns.
CorrectedEstimate estimate_with_noise_left(std::vector<ObservationSet>& sets, const EstimateTask& task);

}  // namespace secular
