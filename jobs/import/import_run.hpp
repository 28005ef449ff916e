#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "measure/data/import_files.hpp"

namespace secular {

struct RecordSummary {
  std::size_t samples = 0;  ///< of a table: rows
  double start_s = 0, duration_s = 0;
  double lowest_hz = 0, highest_hz = 0;  ///< of a table
};

/// What an import made.
struct ImportRun {
  ImportedCampaign imported;
  std::vector<RecordSummary> records;  ///< by record, or table
};

/// The job `import`: a campaign folder of files, or of tables of lines (kind `lines`). `replace`: a campaign
/// that stands in the folder goes. Throws InputError, also for a folder that holds what is read.
ImportRun run_import(const ImportOptions& options, const std::filesystem::path& folder, bool replace);

/// What run_import would make, with everything read and nothing written. Throws InputError as that does for what is
/// in the files.
ImportRun preview_import(const ImportOptions& options);

/// What `secular import --json` prints; `folder`: how it was named.
std::string import_json(const ImportRun& run, const std::string& folder);

}  // namespace secular
