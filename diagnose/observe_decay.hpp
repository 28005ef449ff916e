#pragma once

#include <string>
#include <vector>

#include "diagnose/condition.hpp"
#include "diagnose/sensor_model.hpp"
#include "estimator/identification/observation_set.hpp"

namespace secular {

/// Windows of a free decay of a one-mode model, one condition each: fundamental, second and third harmonic and the
/// mean; errors scaled to the roughness of frequency and growth from window to window. Several modes: a warning.
std::vector<Condition> observe_decay(const Campaign& campaign, std::size_t index, const Record& record,
                                     const CompiledModel& model, const SensorModel& sensors, const Window& window,
                                     std::vector<std::string>& warnings);

}  // namespace secular
