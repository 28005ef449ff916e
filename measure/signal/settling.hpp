#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "measure/signal/ensembles.hpp"

namespace secular {

struct SettlingOptions {
  double false_alarm = 0.01;     ///< for the whole check, shared between its tests
  double largest_drift = 0.005;  ///< relative change over the record that is tolerated although it is significant
  double largest_phase_drift = 0.05;  ///< rad over the record, likewise
};

/// One tone of one channel over the ensembles of a dwell.
struct ToneDrift {
  double amplitude_trend = 0, amplitude_trend_sd = 0;  ///< relative change from first to last ensemble
  double phase_trend = 0, phase_trend_sd = 0;          ///< rad, what a constant frequency does not explain
  double scatter_ratio =
      0;  ///< variance of the amplitude over ensembles about its trend, over that of their errors
  bool settled = true;
};

/// Whether a dwell is steady.
struct SettlingReport {
  std::vector<ToneDrift> tones;  ///< [tone + tones * channel]
  bool settled = true;
  std::string reason;  ///< what moved, for people; empty when settled
};

/// Half-amplitudes of tones over the ensembles of one dwell: amplitude[ensemble](tone, channel), phases against a
/// rotation at a constant common frequency (an offset of that frequency is allowed for when free_frequency), and
/// their standard deviations (of real and imaginary part alike). Trends of logarithmic amplitude and of the phase
/// are tested with Student's t, whose error allows for the overlap of the ensembles; a trend counts when it is both
/// significant and above the tolerance. At least four ensembles: std::invalid_argument.
SettlingReport check_settling(const std::vector<Eigen::MatrixXcd>& amplitude,
                              const std::vector<Eigen::MatrixXd>& amplitude_sd, const EnsembleLayout& layout,
                              bool free_frequency, const SettlingOptions& options = {});

/// The same from samples x channels: the tones of `frequencies` (rad/s) are fitted in every ensemble of the layout.
SettlingReport check_settling(const Eigen::Ref<const Eigen::MatrixXd>& channels, double sample_rate_hz,
                              const std::vector<double>& frequencies, const EnsembleLayout& layout,
                              bool free_frequency, const SettlingOptions& options = {});

}  // namespace secular
