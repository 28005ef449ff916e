#pragma once

#include <vector>

#include "diagnose/evidence/segment_evidence.hpp"
#include "diagnose/verdict/test_outcome.hpp"

namespace secular {

/// As next_dwell(), of records that are compared sample by sample: a decay or a blow that begins, a sweep or noise
/// that is driven, with `level` times as much as a measured one, within half the least and `highest_level` times
/// the most of its kind. Each of a record's stretches has a state of its own, as in the diagnosis, which a
/// hypothesis that judges it finds anew.
ProposedTest next_record(const SegmentEvidence& measured, const std::vector<Hypothesis>& hypotheses,
                         const ProposalOptions& options);

}  // namespace secular
