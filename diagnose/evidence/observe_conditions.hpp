#pragma once

#include <functional>
#include <string>
#include <vector>

#include "diagnose/evidence/condition.hpp"
#include "diagnose/evidence/nonstationarity.hpp"
#include "diagnose/evidence/sensor_model.hpp"
#include "measure/observe/observation_set.hpp"

namespace secular {

struct ObservedConditions {
  std::vector<Condition> conditions;
  std::vector<std::string> warnings;
  std::vector<Nonstationarity> nonstationarity;  ///< of the motion within dwells
};

/// Dwells of a campaign as measured lines. `natural_frequency` (rad/s, by mode) tells which line of
/// each mode is near resonance: a multiple a/b of the excitation's frequency (a, b up to 3), or a pair of lines
/// whose frequencies add up to it or differ by it. A dwell is cut into ensembles, whose scatter about their mean
/// (phases against the excitation's) is the repeatability that everything is measured with; it is pooled over
/// conditions by channel. Dwells that have not settled are left out with a warning.
ObservedConditions observe_conditions(const Campaign& campaign, const RecordReader& read,
                                      const CompiledModel& model, const SensorModel& sensors,
                                      const std::vector<double>& natural_frequency, const Window& window);

}  // namespace secular
