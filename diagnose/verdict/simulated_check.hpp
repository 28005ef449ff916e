#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "diagnose/evidence/condition_rows.hpp"
#include "diagnose/evidence/segment_evidence.hpp"
#include "diagnose/inference/refit.hpp"

namespace secular {

/// How far a channel is from what the full equations of motion give by themselves, nothing measured but the
/// excitation put into them: in the channel's unit.
struct SimulatedError {
  std::string channel;
  double signal = 0;  ///< root mean square of what was measured
  double before = 0;  ///< of the difference, model as it is
  double after = 0;   ///< of the difference, best explanation added
  /// The same two with the numbers that fit this window best: what the model, and the explanation, can do at most.
  std::optional<double> before_fitted, after_fitted;
};

struct SimulatedCheck {
  std::vector<SimulatedError> dwells;    ///< steady motions, found from the measured ones on
  std::size_t steady = 0;                ///< dwells compared
  std::size_t lost = 0;                  ///< dwells for which one of the two has no steady motion near the measured
  std::vector<SimulatedError> segments;  ///< decays, sweeps, broadband records, from a state of each segment's own
  std::vector<SimulatedError> apart;     ///< those of the window to check on, every record in one piece
};

/// Compares the dwells. Unknowns: of the model as it is, and with the best explanation.
SimulatedCheck simulated_dwells(const ConditionModel& model, const std::vector<Condition>& conditions,
                                const Eigen::VectorXd& before, const Eigen::VectorXd& after, unsigned threads);

/// Compares the decays, sweeps and broadband records of a window.
std::vector<SimulatedError> simulated_window(const SegmentEvidence& window, const SensorModel& sensors,
                                             const Eigen::VectorXd& before, const Eigen::VectorXd& after);

/// Fits the free unknowns of both to a window's records, each in one piece, from where they are; fills
/// before_fitted and after_fitted of `errors`, which are those of that window.
void fit_window(const SegmentEvidence& window, const Refit& before, const Refit& after, unsigned threads,
                std::vector<SimulatedError>& errors);

}  // namespace secular
