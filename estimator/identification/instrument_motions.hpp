#pragma once

#include <cstddef>
#include <vector>

#include "estimator/identification/case_regression.hpp"

namespace secular {

/// How much of what a record's balance leaves is taken off: as much as is told to be no noise, or all.
enum class TakenOff { told, all };

/// docs/inference.md (53), (54): by observation, the motion that a dwell of `set`, which says how much natural
/// frequencies differ from record to record (ObservationSet::frequency_scatter), would have if none did and without
/// noise, by the equations at `point`; less of it where a record's scatter does not stand out of its noise. In
/// eight steps, of which each is solved by Newton's method. Not found where the response ends before: then of all
/// observations of the record. `blocks`: indices into CompiledCase::blocks.
std::vector<InstrumentMotion> instrument_motions(const ObservationSet& set, const std::vector<std::size_t>& blocks,
                                                 const EquationPoint& point, TakenOff taken_off = TakenOff::told);

/// docs/inference.md (55): whether a fit by such motions has bounded intervals, and whether the records that have
/// no such motion are so few that what they differ by does not matter.
bool instruments_tell(const CaseFit& fit);

}  // namespace secular
