#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "diagnose/segment_motion.hpp"
#include "diagnose/sensor_model.hpp"
#include "estimator/identification/observation_set.hpp"

namespace secular {

/// A stretch of a record that is compared sample by sample with the full equations of motion, from a state of its
/// own.
struct Segment {
  std::size_t record = 0;
  int fold = 0;
  double time_s = 0;  ///< of its middle, since the campaign began
  double sample_s = 0;
  Eigen::MatrixXd excitation;  ///< excitation channels x (2*samples - 1), every half sample; empty: none
  Eigen::MatrixXd response;    ///< response channels x samples
  Eigen::VectorXd noise_sd;    ///< response channels
  int substeps = 1;
};

enum class SegmentLength {
  turns,  ///< some turns of the lowest mode
  whole   ///< all that the window holds of a record
};

/// Free decays, impacts, sweeps and broadband records as segments, evenly spread over the record where it holds
/// more samples than are needed (`most_samples` in all; of no effect on whole ones). Decays begin where the
/// structure swings freely. Samples are thinned where the record is much faster than the highest mode.
std::vector<Segment> cut_segments(const Campaign& campaign, const RecordReader& read, const SensorModel& sensors,
                                  const std::vector<double>& natural_frequency, const Window& window,
                                  SegmentLength length_of_each, Eigen::Index most_samples,
                                  std::vector<std::string>& warnings);

}  // namespace secular
