#pragma once

#include <string>
#include <vector>

#include "measure/data/campaign.hpp"
#include "motion/simulate/experiment.hpp"

namespace secular {

/// Applies gain, offset, cross-axis sensitivity and skew to a noise-free record, in this order for every channel.
/// `names` by channel; with `excited` channel 0 is the excitation, whose true signal cross-axis faults pick up. A
/// late channel is shifted by a windowed sinc interpolation of 32 samples; near the record's ends it repeats end
/// values.
void apply_sensor_faults(const std::vector<SensorFault>& faults, const std::vector<std::string>& names,
                         bool excited, Record& record);

/// Saturation of one channel, after its noise.
void clip(const std::vector<SensorFault>& faults, const std::string& name, std::vector<double>& samples);

}  // namespace secular
