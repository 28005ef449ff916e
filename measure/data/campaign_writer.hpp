#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "measure/data/campaign.hpp"

namespace secular {

/// Takes records as they are made; the campaign's channels and sample rate stand by then.
using RecordSink = std::function<void(const Campaign& campaign, const RecordEntry& entry, Record&& record)>;

/// Writes a campaign folder, records as CSV (whatever the extension of RecordEntry::file), each as soon as it is
/// there. The folder appears when all is written, and nothing is left behind by a writer that goes without
/// finish(). What is written is what read_campaign and read_record restore bit by bit. Throws InputError if
/// `folder` exists and is not empty, for samples that are not finite and for whatever read_campaign would refuse;
/// std::invalid_argument if samples and campaign do not fit together.
class CampaignWriter {
 public:
  /// `replace`: a campaign that stands there goes once all is written. InputError for anything else that stands
  /// there (fault_of_replaced).
  explicit CampaignWriter(const std::filesystem::path& folder, bool replace = false);
  ~CampaignWriter();
  /// Writes the samples of a record; from any thread. The entry belongs into the campaign that finish() gets.
  void write(const Campaign& campaign, const RecordEntry& entry, const Record& record);
  /// The same of a table of lines: its entry is one of kind `lines` without a row.
  void write(const Campaign& campaign, const RecordEntry& entry, const std::vector<LineRow>& rows);
  void finish(const Campaign& campaign);

 private:
  struct Building;
  std::unique_ptr<Building> building_;
};

}  // namespace secular
