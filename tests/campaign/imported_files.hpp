#pragma once

#include <utility>
#include <vector>

#include "measure/data/import_files.hpp"

namespace secular {

/// What an import makes of files, with the records that it would write.
struct ImportedFiles : ImportedCampaign {
  std::vector<Record> samples;
};

inline ImportedFiles import_files(const ImportOptions& options) {
  std::vector<Record> samples;
  ImportedCampaign imported = import_files(
      options, [&](const Campaign&, const RecordEntry&, Record&& record) { samples.push_back(std::move(record)); });
  return {std::move(imported), std::move(samples)};
}

}  // namespace secular
