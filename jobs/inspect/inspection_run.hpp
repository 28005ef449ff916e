#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "jobs/inspect/record_pictures.hpp"
#include "measure/data/campaign.hpp"
#include "measure/data/inspection.hpp"
#include "measure/disturbances/disturbance.hpp"
#include "measure/observe/observation_set.hpp"

namespace secular {

struct InspectionRequest {
  std::string path;                  ///< campaign folder (or its campaign.toml) or file, or what to call `campaign`
  std::optional<Campaign> campaign;  ///< in place of a folder
  Window window;                     ///< its records and its times; a band has no meaning
  bool whole = false;                ///< read everything, however large
  bool pictures = false;             ///< for inspection_report()
};

/// A campaign with the records that were asked for, and what is in them.
struct InspectedCampaign {
  Campaign campaign;
  std::vector<RecordInspection> records;
  std::vector<Disturbance> disturbances;
  std::vector<RecordPictures> pictures;  ///< of records with samples, where they are asked for
};

/// A file, and what is in it beside a motion that nothing is said of.
struct InspectedFile {
  FileInspection file;
  Campaign campaign;  ///< of this one record
  std::vector<Disturbance> disturbances;
  std::vector<RecordPictures> pictures;
};

/// One of the two.
struct Inspection {
  std::string path;
  std::optional<InspectedCampaign> campaign;
  std::optional<InspectedFile> file;
};

/// The campaign's folder, where a path is that of its campaign.toml; else the path itself.
std::filesystem::path campaign_or_file(const std::string& path);

/// The job `inspect`. Throws InputError.
Inspection inspect(const InspectionRequest& request);

/// What `secular inspect --json` prints.
std::string inspection_json(const Inspection& found);

/// How long so many samples take, s.
double recorded_s(const TimeAxis& axis, std::size_t samples);

}  // namespace secular
