#include "jobs/import/import_run.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "measure/data/campaign.hpp"
#include "measure/data/campaign_target.hpp"
#include "measure/data/import_tables.hpp"
#include "measure/data/names.hpp"

namespace secular {
namespace {

RecordSummary summary_of(const std::vector<LineRow>& rows) {
  RecordSummary summary{rows.size(), 0, 0, rows.front().frequency_hz, rows.front().frequency_hz};
  for (const LineRow& row : rows) {
    summary.lowest_hz = std::min(summary.lowest_hz, row.frequency_hz);
    summary.highest_hz = std::max(summary.highest_hz, row.frequency_hz);
  }
  return summary;
}

// `writer`: none where nothing is to be written.
ImportedCampaign import_into(CampaignWriter* writer, const ImportOptions& options,
                             std::vector<RecordSummary>& records) {
  if (parse_record_kind(options.kind) == RecordKind::lines)
    return import_tables(options,
                         [&](const Campaign& campaign, const RecordEntry& entry, const std::vector<LineRow>& rows) {
                           if (writer) writer->write(campaign, entry, rows);
                           records.push_back(summary_of(rows));
                         });
  return import_files(options, [&](const Campaign& campaign, const RecordEntry& entry, Record&& record) {
    if (writer) writer->write(campaign, entry, record);
    records.push_back(
        {record.samples(), record.start_s, static_cast<double>(record.samples()) / record.sample_rate_hz, 0, 0});
  });
}

}  // namespace

ImportRun run_import(const ImportOptions& options, const std::filesystem::path& folder, bool replace) {
  for (const std::filesystem::path& file : options.files) check_apart(folder, file, "the file");
  CampaignWriter writer(folder, replace);
  ImportRun run;
  run.imported = import_into(&writer, options, run.records);
  writer.finish(run.imported.campaign);
  return run;
}

ImportRun preview_import(const ImportOptions& options) {
  ImportRun run;
  run.imported = import_into(nullptr, options, run.records);
  return run;
}

std::string import_json(const ImportRun& run, const std::string& folder) {
  const auto& [imported, records] = run;
  const Campaign& campaign = imported.campaign;
  nlohmann::ordered_json summary = {{"campaign", folder}, {"name", campaign.name}};
  if (campaign.sample_rate_hz > 0) summary["sample_rate_hz"] = campaign.sample_rate_hz;
  summary["channels"] = nlohmann::ordered_json::array();
  for (const Channel& channel : campaign.channels)
    summary["channels"].push_back({{"name", channel.name},
                                   {"role", to_string(channel.role)},
                                   {"quantity", to_string(channel.quantity)},
                                   {"unit", channel.unit}});
  summary["records"] = nlohmann::ordered_json::array();
  for (std::size_t r = 0; r < campaign.records.size(); ++r) {
    if (campaign.records[r].kind == RecordKind::lines) {
      summary["records"].push_back({{"file", campaign.records[r].file},
                                    {"kind", "lines"},
                                    {"rows", records[r].samples},
                                    {"lowest_hz", records[r].lowest_hz},
                                    {"highest_hz", records[r].highest_hz}});
      continue;
    }
    summary["records"].push_back({{"file", campaign.records[r].file},
                                  {"kind", to_string(campaign.records[r].kind)},
                                  {"from", imported.sources[r].string()},
                                  {"samples", records[r].samples},
                                  {"start_s", records[r].start_s},
                                  {"duration_s", records[r].duration_s}});
  }
  summary["left_out"] = imported.left_out;
  summary["warnings"] = imported.warnings;
  summary["converted"] = nlohmann::ordered_json::array();
  for (const ConvertedChannel& channel : imported.converted)
    summary["converted"].push_back({{"name", channel.name}, {"from", channel.from_unit}, {"to", channel.to_unit}});
  return summary.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace secular
