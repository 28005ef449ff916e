#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "measure/observe/observation_set.hpp"

namespace secular {

/// A decay beyond the window that was fitted, predicted by the full equations with the estimated parameters.
struct HeldOutPrediction {
  std::size_t record = 0;
  double from_s = 0, to_s = 0;  ///< predicted span, after the fitted window
  double rms = 0,
         amplitude = 0;  ///< root mean square of measured minus predicted; largest measured excursion there
  std::vector<double> time, measured, predicted;  ///< samples of the span, offset removed
};

/// Starts from the state at the end of the fitted window (least squares over its last ten periods, nothing later is
/// used) and integrates to the record's end. Nothing if fewer than five periods lie beyond the window.
std::optional<HeldOutPrediction> predict_held_out_decay(const Campaign& campaign, const RecordReader& read_samples,
                                                        const ObservationSet& measured, std::size_t record,
                                                        const Eigen::VectorXd& parameters, const Window& window);

}  // namespace secular
