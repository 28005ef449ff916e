#pragma once

#include <string>
#include <vector>

#include "app/inspect/record_pictures.hpp"
#include "measure/data/campaign.hpp"
#include "measure/data/inspection.hpp"
#include "measure/disturbances/disturbance.hpp"

namespace secular::app {

/// A campaign with the records that are asked for, and what is in them.
struct InspectedCampaign {
  Campaign campaign;
  std::vector<RecordInspection> records;
  std::vector<Disturbance> disturbances;
  std::vector<RecordPictures> pictures;  ///< of records with samples; where a report is asked for
};

/// A file, and what is in it beside a motion that nothing is said of.
struct InspectedFile {
  FileInspection file;
  Campaign campaign;  ///< of this one record
  std::vector<Disturbance> disturbances;
  std::vector<RecordPictures> pictures;
};

/// Why `identify` cannot use a record: no even time, or a channel that says nothing. Empty if it can.
std::string record_obstacle(const InspectedCampaign& inspected, std::size_t record);

/// "usable for identify: 17 of 19 records; records/0004.csv: ..."
std::string usable_sentence(const InspectedCampaign& inspected);

/// report.html, with `command` at its foot.
std::string inspection_report(const InspectedCampaign& inspected, const std::string& source,
                              const std::string& command);
std::string inspection_report(const InspectedFile& inspected, const std::string& source, const std::string& command,
                              const std::string& import_command);

}  // namespace secular::app
