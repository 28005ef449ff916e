#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "measure/observe/observation_set.hpp"

namespace secular {

/// A decay, or the part of it beyond the window that was fitted, as the full equations make it with the estimated
/// parameters.
struct HeldOutPrediction {
  std::size_t record = 0;
  double from_s = 0, to_s = 0;  ///< predicted span
  double rms = 0,
         amplitude = 0;  ///< root mean square of measured minus predicted; largest measured excursion there
  std::vector<double> time, measured, predicted;  ///< samples of the span, offset removed
};

/// Starts from the state at the end of the fitted window (least squares over its last ten periods, nothing later is
/// used) and integrates to the record's end. Nothing if fewer than five periods lie beyond the window.
std::optional<HeldOutPrediction> predict_held_out_decay(const Campaign& campaign, const RecordReader& read_samples,
                                                        const ObservationSet& measured, std::size_t record,
                                                        const Eigen::VectorXd& parameters, const Window& window);

/// The same over the part of the record that was fitted, in one piece: from the state at the first window (least
/// squares over its first ten periods) to the end of the last one. Nothing if that is shorter than fifteen periods.
std::optional<HeldOutPrediction> follow_decay(const Campaign& campaign, const RecordReader& read_samples,
                                              const ObservationSet& measured, std::size_t record,
                                              const Eigen::VectorXd& parameters);

}  // namespace secular
