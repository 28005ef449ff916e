#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "jobs/inspect/inspection_run.hpp"

namespace secular {

/// Why `identify` cannot use a record: no even time, or a channel that says nothing. Empty if it can.
std::string record_obstacle(const InspectedCampaign& inspected, std::size_t record);

/// "usable for identify: 17 of 19 records; records/0004.csv: ..."
std::string usable_sentence(const InspectedCampaign& inspected);

/// history_N and spectrum_N of record N (from 1) of an inspection with pictures.
std::vector<report::NamedFigure> inspection_figures(const Inspection& inspected);

/// What the records of a campaign were simulated from.
struct SimulatedFrom {
  std::string model, experiment;  ///< names
  std::string text;               ///< of the experiment file
  std::uint64_t seed = 0;         ///< of the measurement noise
};

/// report.html of an inspection with pictures, with `command` at its foot. `simulated`: of a campaign that
/// `simulate` has made; the report says first what it made it from.
std::string inspection_report(const Inspection& inspected, const std::string& command,
                              const SimulatedFrom* simulated = nullptr);

}  // namespace secular
