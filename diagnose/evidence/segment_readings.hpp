#pragma once

#include "diagnose/evidence/segment.hpp"

namespace secular {

/// What truly drives a segment, where its excitation channels have these faults.
DrivingSignal true_signal(const Segment& segment, const std::vector<ChannelFaults>& excitation);

/// Whether it is the same with these as with those.
bool drive_alike(const Segment& segment, const std::vector<ChannelFaults>& these,
                 const std::vector<ChannelFaults>& those);

/// Measured minus computed samples of a motion, in units of each channel's noise, channel after channel.
Eigen::VectorXd reading_errors(const Segment& segment, const SensorModel& sensors, const Faults& faults,
                               const DrivingSignal& signal, const StretchOfMotion& motion);

}  // namespace secular
