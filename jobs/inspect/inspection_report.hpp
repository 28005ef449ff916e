#pragma once

#include <cstddef>
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

/// report.html of an inspection with pictures, with `command` at its foot.
std::string inspection_report(const Inspection& inspected, const std::string& command);

}  // namespace secular
