#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "diagnose/evidence/discrepancy.hpp"

namespace secular {

/// Of a natural frequency, relative: no scatter, and nothing that a record feels.
inline constexpr double no_scatter = 1e-9;

/// Whether frequencies of any mode may differ with these standard deviations.
inline bool is_scatter(const Eigen::VectorXd& sd) {
  return (sd.array() > no_scatter).any();
}

/// How natural frequencies differ from record to record (docs/inference.md (26)).
struct FrequencyScatter {
  /// By mode, relative, about what follows the settings; 0: records do not differ beyond their noise.
  Eigen::VectorXd sd;
  double freedom = INFINITY;          ///< of the least known of them
  std::vector<OwnFrequency> records;  ///< of modes that scatter
  /// Departures are a smooth function of the records' level, frequency, amplitude and time (F law, 5 %), as what a
  /// missing law does to them is; also where there are too few records to tell.
  bool follows_settings = false;
  bool suffices = true;  ///< what it was found beside leaves no more than noise
  double at_random = 0;  ///< largest share of a mode's variance between records that follows no setting

  bool any() const { return sd.size() > 0 && sd.maxCoeff() > 0; }
};

/// Scatter of the natural frequencies of a fit, of a discrepancy that has been frozen there and admits it.
FrequencyScatter scatter_about(const Discrepancy& discrepancy, const Eigen::VectorXd& unknowns, std::size_t modes);

/// What a discrepancy is to admit for this scatter, by mode.
Eigen::VectorXd admitted(const FrequencyScatter& scatter);

/// Whether two are the same as far as it matters to what is fitted beside them.
bool is_as_large(const Eigen::VectorXd& admitted, const Eigen::VectorXd& before);

}  // namespace secular
