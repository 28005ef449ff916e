#pragma once

#include <functional>
#include <string>
#include <vector>

#include "diagnose/evidence/condition.hpp"
#include "diagnose/evidence/nonstationarity.hpp"
#include "diagnose/evidence/observe_dwell.hpp"
#include "measure/observe/observation_set.hpp"

namespace secular {

struct ObservedConditions {
  std::vector<Condition> conditions;
  std::vector<std::string> warnings;
  std::vector<Nonstationarity> nonstationarity;  ///< of the motion within dwells
};

/// Dwells of a campaign as measured lines. Its natural frequencies tell which line of each mode is near resonance:
/// a multiple a/b of the excitation's frequency (a, b up to 3), or a pair of lines whose frequencies add up to it
/// or differ by it. A dwell is cut into ensembles, whose scatter about their mean (phases against the excitation's)
/// is the repeatability that everything is measured with; it is pooled over conditions by channel and frequency.
/// Dwells that have not settled are left out with a warning.
ObservedConditions observe_conditions(const DwellContext& context, const RecordReader& read);

}  // namespace secular
