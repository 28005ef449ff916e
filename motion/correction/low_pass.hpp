#pragma once

#include <optional>
#include <span>

#include "estimator/identification/record_lateness.hpp"
#include "measure/observe/observation_set.hpp"
#include "motion/correction/equal_poles.hpp"

namespace secular {

/// What makes all records of a campaign late alike may be a low-pass, which takes amplitude off as well: the
/// lateness that all records of all cases share, docs/inference.md (71): none where delays differ as those that
/// come at random do, where a quarter of a period or more is needed, or where no case's records are late.
/// `measured`: the sets of these cases.
std::optional<EqualPoles> shared_low_pass(std::span<const CaseLateness> lateness,
                                          std::span<const ObservationSet> measured);

}  // namespace secular
