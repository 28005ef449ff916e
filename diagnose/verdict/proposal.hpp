#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnose/evidence/segment_evidence.hpp"
#include "diagnose/verdict/naming.hpp"
#include "diagnose/verdict/next_dwell.hpp"

namespace secular {

/// The test that should come next.
struct NextExperiment {
  std::optional<ProposedTest> test;  ///< the best one, whether it is good enough to be proposed or not
  bool proposed = false;
  std::vector<std::string> separates;  ///< effects that the test tells apart
  std::string reason;                  ///< why none is proposed
};

/// The dwell, where none is worth it or none was measured the record of another kind, that best parts the rivals of
/// the best explanation: the others of its set; where it stands alone, the one that comes nearest. `rivals`:
/// ranked, with `naming` by name_effects. `segments`: null where there are none.
NextExperiment propose_experiment(const std::vector<Rival>& rivals, const Naming& naming,
                                  const ConditionModel& model, const std::vector<Condition>& conditions,
                                  const SegmentEvidence* segments, const ProposalOptions& options);

}  // namespace secular
