#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/procedure/known_truth.hpp"
#include "app/procedure/thesis_procedures.hpp"

namespace secular::app {

/// Levels closer than this, relative, are one.
inline constexpr double same_level = 0.01;

/// Mean over the ensembles of one dwell.
struct DwellMean {
  std::size_t record = 0;
  std::string group;
  double frequency = 0, forcing = 0;       ///< of the first excitation: rad/s, peak in its channel's unit
  double amplitude = 0, amplitude_sd = 0;  ///< peak of the first mode, and its scatter between ensembles
};

/// One a record, in their order.
std::vector<DwellMean> dwell_means(const Campaign& campaign, const ObservationSet& measured);

/// What every procedure works on; each adds its sections and warnings to `run`.
struct ProcedureData {
  const ProcedureRequest& request;
  ProcedureRun& run;
  KnownTruth truth;
  std::vector<DwellMean> dwells;
  double centre = 0;         ///< excitation frequency at exact resonance, rad/s
  std::string unit;          ///< of a modal displacement
  bool values_only = false;  ///< no tests: nothing but what the methods recover

  /// Whether --method names it, or names none.
  bool wants(const std::string& method) const;
};

/// What a method makes of a campaign, and what is true where that is known.
struct RecoveredValue {
  double value = 0;
  std::optional<double> sd, as_printed, truth;
};

/// A row with what the source's tables print for it, by equation and name.
ProcedureRow procedure_row(const std::string& name, const std::string& unit, const std::string& equation,
                           const RecoveredValue& recovered);

}  // namespace secular::app
