#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnose/verdict/naming.hpp"
#include "diagnose/verdict/next_experiment.hpp"

namespace secular {

/// The test that should come next.
struct NextExperiment {
  std::optional<ProposedDwell> dwell;  ///< the best one, whether it is good enough to be proposed or not
  bool proposed = false;
  std::vector<std::string> separates;  ///< effects that the test tells apart
  std::string reason;                  ///< why none is proposed
};

/// The dwell that best parts the rivals of the best explanation: the others of its set; where it stands alone, the
/// one that comes nearest. `rivals`: ranked, with `naming` by name_effects.
NextExperiment propose_experiment(const std::vector<Rival>& rivals, const Naming& naming,
                                  const ConditionModel& model, const std::vector<Condition>& conditions,
                                  const ProposalOptions& options);

}  // namespace secular
