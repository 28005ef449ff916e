#pragma once

#include <string>
#include <vector>

#include "jobs/identify/case_view.hpp"

namespace secular {

/// Ensembles of one record: mean and scatter of the peak amplitude of the first oscillating mode.
struct DwellMean {
  std::size_t record = 0;
  double frequency_hz = 0, forcing = 0;    ///< forcing: peak, in the excitation's unit
  double amplitude = 0, amplitude_sd = 0;  ///< sd of the mean
  double phase_sd = 0;                     ///< degrees, of the mean
  double model_amplitude = 0;              ///< of the replayed motion; 0 where there is none
  double phase_difference = 0;             ///< measured minus replayed, degrees
};
std::vector<DwellMean> dwell_means(const CaseView& view);

/// Dwells of one excitation level: within `same_level` of the lowest of them.
struct ResponseLevel {
  double forcing = 0;  ///< mean, peak
  std::vector<DwellMean> dwells;
};
inline constexpr double same_level = 0.05;

/// Rising levels.
std::vector<ResponseLevel> response_levels(const CaseView& view);

/// A piece of the model's response curve at one level: peak amplitude of the first oscillating mode against the
/// excitation's frequency, all of it stable or all of it not.
struct CurvePiece {
  bool stable = true;
  std::vector<double> frequency_hz, amplitude;
};

/// Steady responses of the case's modulation equations at the representative parameters and the level's excitation,
/// over the frequencies from `low_hz` to `high_hz`: those found at the level's strongest dwell, and what crosses
/// them, but the state of rest. Empty where the case has not one excitation, or the estimate leaves open lumps of
/// its steady motions.
std::vector<CurvePiece> model_curve(const CaseView& view, const ResponseLevel& level, double low_hz,
                                    double high_hz);

}  // namespace secular
