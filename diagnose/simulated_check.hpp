#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "diagnose/condition_rows.hpp"
#include "diagnose/segment_evidence.hpp"

namespace secular {

/// How far a channel is from what the full equations of motion give by themselves, nothing measured but the
/// excitation put into them: in the channel's unit.
struct SimulatedError {
  std::string channel;
  double signal = 0;  ///< root mean square of what was measured
  double before = 0;  ///< of the difference, model as it is
  double after = 0;   ///< of the difference, best explanation added
};

struct SimulatedCheck {
  std::vector<SimulatedError> dwells;    ///< steady motions, found from the measured ones on
  std::size_t steady = 0;                ///< dwells compared
  std::size_t lost = 0;                  ///< dwells for which one of the two has no steady motion near the measured
  std::vector<SimulatedError> segments;  ///< decays, sweeps, broadband records, from a state of each segment's own
  std::vector<SimulatedError> apart;     ///< those of the window to check on, every record in one piece
};

/// `segments` and `apart` may be null.
SimulatedCheck simulated_check(const ConditionModel& model, const std::vector<Condition>& conditions,
                               const SegmentEvidence* segments, const SegmentEvidence* apart,
                               const Eigen::VectorXd& before, const Eigen::VectorXd& after, unsigned threads);

}  // namespace secular
